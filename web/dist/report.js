(()=>{function Uf(i){try{if(Uint8Array.fromBase64)return Uint8Array.fromBase64(i);let e=atob(i),t=new Uint8Array(e.length);for(let n=0;n<t.length;++n)t[n]=e.charCodeAt(n);return t}catch{throw new Error("the mesh data are not valid base64")}}function Of(i,e,t){for(let[n,s]of Object.entries(e??{}))s==null||s===!1||(n.startsWith("on")?i.addEventListener(n.slice(2),s):i.setAttribute(n,s===!0?"":s));return i.append(...t.flat().filter(n=>n!=null&&n!==!1)),i}var z=(i,e,...t)=>Of(document.createElement(i),e,t),qt=(i,e,...t)=>Of(document.createElementNS("http://www.w3.org/2000/svg",i),e,t);function ch(i,e,t){let n=z("button",{type:"button",class:"em-button","aria-pressed":"false",title:e,onclick:t},i);return{button:n,set:s=>n.setAttribute("aria-pressed",String(s))}}function ks(i,e,t){let n=new Map(e.map(([s,r,o])=>[s,z("button",{type:"button",class:"em-button","aria-pressed":"false",title:o,onclick:()=>t(s)},r)]));return{element:z("div",{class:"em-segments",role:"group","aria-label":i},...n.values()),set(s){for(let[r,o]of n)o.setAttribute("aria-pressed",String(r===s))}}}function wa(i,e,t){let n=z("select",{"aria-label":i,onchange:()=>t(n.value)},...e.map(([s,r])=>z("option",{value:s},r)));return{element:n,set:s=>{n.value=s}}}function bo(i,{min:e,max:t,step:n},s){let r=z("input",{type:"range",min:e,max:t,step:n,"aria-label":i,oninput:()=>s(r.valueAsNumber)});return{element:r,set:o=>{r.value=o}}}function hh(i,e){let t=z("button",{type:"button",class:"em-button"},i);return t.addEventListener("click",async()=>{let n=await t0(e());t.textContent=n?"Copied":"Could not copy",setTimeout(()=>{t.textContent=i},1600)}),t}async function t0(i){try{return await navigator.clipboard.writeText(i),!0}catch{let e=z("textarea",{class:"em-offscreen","aria-hidden":"true"});e.value=i,document.body.append(e),e.select();let t=document.execCommand("copy");return e.remove(),t}}var ds=class extends Error{};var uh=i=>i>>>1^-(i&1);function n0(i,e,t){if(t===1)return i;let n=new Uint32Array(e);for(let s=0;s<t;++s){let r=8*s,o=s*e;for(let a=0;a<e;++a)n[a]|=i[o+a]<<r}return n}var Bf={unsigned:i=>i,signed:i=>Int32Array.from(i,uh),delta(i,e){let t=new Int32Array(i.length);for(let n=0;n<e&&n<i.length;++n)t[n]=uh(i[n]);for(let n=e;n<i.length;++n)t[n]=t[n-e]+uh(i[n]);return t},highwater(i){let e=new Int32Array(i.length),t=0;for(let n=0;n<i.length;++n)e[n]=t-i[n],i[n]===0&&++t;return e}};function i0(i,{count:e,components:t=1,planes:n,rule:s}){if(!Object.hasOwn(Bf,s))throw new Error(`unknown rule "${s}"`);if(!(n>=1&&n<=4))throw new Error(`${n} byte planes, where 1 to 4 are possible`);if(i.length!==e*n)throw new Error(`${e*n} bytes expected, ${i.length} found`);return Bf[s](n0(i,e,n),t)}async function s0(i){let e=new Blob([i]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(e).arrayBuffer())}function kf(i,e){let t=new Map;async function n(s){if(!Object.hasOwn(i,s))return null;let r=i[s],o=r.offset+r.bytes;if(!(r.offset>=0&&o<=e.length))throw new Error(`array "${s}" ends at byte ${o} of ${e.length}: the file is cut short`);try{return i0(await s0(e.subarray(r.offset,o)),r)}catch(a){throw new Error(`array "${s}" is damaged: ${a.message}`)}}return s=>(t.has(s)||t.set(s,n(s)),t.get(s))}var ii=[{name:"triangle",vertices:3,volume:!1,faces:[[0,1,2]]},{name:"quad",vertices:4,volume:!1,faces:[[0,1,2,3]]},{name:"tet",vertices:4,volume:!0,faces:[[0,1,3],[1,2,3],[2,0,3],[0,2,1]]},{name:"pyramid",vertices:5,volume:!0,faces:[[0,3,2,1],[0,1,4],[1,2,4],[2,3,4],[3,0,4]]},{name:"wedge",vertices:6,volume:!0,faces:[[0,1,2],[3,5,4],[0,3,4,1],[1,4,5,2],[2,5,3,0]]},{name:"hex",vertices:8,volume:!0,faces:[[0,4,7,3],[1,2,6,5],[0,1,5,4],[3,7,6,2],[0,3,2,1],[4,5,6,7]]},{name:"polygon",volume:!1}];function zf(i){let e=new Map;for(let t of i)t.forEach((n,s)=>{let r=t[(s+1)%t.length];e.set(`${Math.min(n,r)} ${Math.max(n,r)}`,[n,r])});return[...e.values()]}var r0=ii.map(({faces:i})=>i&&zf(i)),o0=[];function Ar(i,e){let{faces:t}=ii[i.kind[e]];if(t)return t;let n=i.first[e+1]-i.first[e];return o0[n]??=[Array.from({length:n},(s,r)=>r)]}var Aa=(i,e)=>r0[i.kind[e]]??zf(Ar(i,e)),Ta=["free","fixed","slides on a curve","slides on a surface","tied","held"];var zs=2048,Ea=i=>Math.max(1,Math.ceil(i/zs))*zs;async function Vf(i,e){let{mesh:t}=i,[n,s,r,o,a]=await Promise.all(["cell_kind","cell_vertices","points","moves","polygon_size"].map(e));if(!n||!s||!r)throw new Error("the report holds no mesh");let l=a0(n,a??[],s.length),c=r.length/3;l0(s,c);let h=c0(r),{scale:f,origin:u}=t.points,d=fh(r,null,h,f),g=o?fh(r,o,h,f):null,M=u0(t,d,g,async p=>{let m=await e(`iterate_${p}`);if(!m)throw new Error(`the positions of iterate ${p} are missing`);return fh(r,m,h,f)});return{dimension:t.dimension,type:t.type,cellCount:n.length,vertexCount:c,kind:n,first:l,vertices:s,before:d,after:g,stops:M,box:h0(d,c),toFile:p=>p.map((m,y)=>m+u[y]+f*h[y]),metrics:t.metrics??[],metric:p=>f0(p,t,e,n.length),details:()=>d0(i,e,n.length,c),featureEdges:()=>e("feature_edges")}}function a0(i,e,t){let n=new Uint32Array(i.length+1),s=0;for(let r=0;r<i.length;++r){if(i[r]>=ii.length)throw new Error(`cell ${r} is of unknown kind ${i[r]}`);let o=ii[i[r]].vertices??e[s++];if(!(o>=3))throw new Error(`polygon ${r} has no size, or less than three corners`);n[r+1]=n[r]+o}if(n[i.length]!==t)throw new Error(`the cells have ${n[i.length]} corners, the data ${t}`);return n}function l0(i,e){for(let t=0;t<i.length;++t)if(!(i[t]>=0&&i[t]<e))throw new Error(`a cell uses vertex ${i[t]}, but the mesh has ${e} points`)}function c0(i){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let n=0;n<i.length;++n){let s=n%3;i[n]<e[s]&&(e[s]=i[n]),i[n]>t[s]&&(t[s]=i[n])}return e.map((n,s)=>i.length?Math.round((n+t[s])/2):0)}function fh(i,e,t,n){let s=i.length/3,r=new Float32Array(4*Ea(s));for(let o=0;o<s;++o)for(let a=0;a<3;++a){let l=e?e[3*o+a]:0;r[4*o+a]=n*(i[3*o+a]-t[a]+l)}return r}function h0(i,e){let t=[1/0,1/0,1/0],n=[-1/0,-1/0,-1/0];for(let r=0;r<e;++r)for(let o=0;o<3;++o){let a=i[4*r+o];a<t[o]&&(t[o]=a),a>n[o]&&(n[o]=a)}let s=e?Math.hypot(...n.map((r,o)=>r-t[o])):0;return{low:t,high:n,diagonal:s||1}}function u0(i,e,t,n){let s=[{label:"before",points:async()=>e}];return t&&((i.iterates??[]).forEach((r,o)=>{if(r===0)return;let a;s.push({label:`iterate ${r}`,points:()=>a??=n(o)})}),s.push({label:"after",points:async()=>t})),s}async function f0(i,e,t,n){let s=(e.metrics??[]).find(l=>l.name===i);if(!s)throw new Error(`the report has no metric "${i}"`);let[r,o]=await Promise.all([t(`before_${i}`),t(`after_${i}`)]),a=r??o;if(!a)throw new Error(`the values of metric "${i}" are missing`);for(let l of[r,o])if(l&&l.length!==n)throw new Error(`${l.length} values of "${i}" for ${n} cells`);return{...s,before:r??a,after:o??a}}async function d0(i,e,t,n){let[s,r,o,a,l]=await Promise.all(["cell_id","vertex_id","cell_group","vertex_hold","cell_flags"].map(e)),{cell_names:c,vertex_names:h}=i.mesh,f=(u,d)=>g=>String(u?.[g]??d?.[g]??g);return{cellName:f(c,s),vertexName:f(h,r),groupName:u=>o?.[u]?i.groups?.[o[u]-1]??"":"",hold:a??new Uint8Array(n),hasHolds:!!a?.some(u=>u>0),flags:l??new Uint8Array(t)}}var Ca=(i,e)=>e===255?NaN:i.low+(i.high-i.low)*e/254;function Tr(i,e,t){let n=[0,0,0],s=i.first[t],r=i.first[t+1];for(let o=s;o<r;++o)for(let a=0;a<3;++a)n[a]+=e[4*i.vertices[o]+a];return n.map(o=>o/(r-s))}function Ra(i,e){let t=new Float32Array(4*Ea(i.cellCount)),{first:n,vertices:s}=i;for(let r=0;r<i.cellCount;++r){let o=n[r],a=n[r+1],l=0,c=0,h=0;for(let u=o;u<a;++u){let d=4*s[u];l+=e[d],c+=e[d+1],h+=e[d+2]}let f=1/(a-o);t[4*r]=l*f,t[4*r+1]=c*f,t[4*r+2]=h*f}return t}var Gf=(i,e)=>e!==255?e:i.better==="lower"?255:-1;function dh(i){let e=new Float64Array(51),t=0;for(let n=0;n<i.length;++n)i[n]===255?++t:++e[i[n]/5|0];return{bars:e,undefinedCount:t}}function Hf(i,e,t){let n=new Float64Array(256);for(let o=0;o<e.length;++o)++n[e[o]];let s=t*e.length-n[255];if(i.better==="lower"){let o=255;for(;s>0&&o>0;)s-=n[--o];return[o,255]}let r=-1;for(;s>0&&r<254;)s-=n[++r];return[-1,r]}var Xf=0,Ia=1,p0=2;function qf(i,e,t,n){let s=new Uint8Array(i.cellCount).fill(Ia),r=t.others==="fade"?p0:Xf;if(t.show==="listed"){s.fill(r);for(let a of n)s[a]=Ia}else t.show!=="all"&&e&&Wf(s,e,e.after,Hf(e,e.after,Number(t.show)),r);t.range&&e&&Wf(s,e,e[t.rangeOf],t.range,r),t.cut&&m0(s,Yf(i),t.cut);let o=0;for(let a=0;a<s.length;++a)o+=s[a]===Ia;return{of:s,count:o}}function Wf(i,e,t,[n,s],r){let o=Uint8Array.from({length:256},(a,l)=>{let c=Gf(e,l);return c>=n&&c<=s});for(let a=0;a<i.length;++a)o[t[a]]||(i[a]=r)}function m0(i,e,{normal:[t,n,s],distance:r}){for(let o=0;o<i.length;++o){let a=4*o;t*e[a]+n*e[a+1]+s*e[a+2]>r&&(i[o]=Xf)}}var ph=new WeakMap;function Yf(i){return ph.has(i)||ph.set(i,Ra(i,i.before)),ph.get(i)}function Pa(i,[e,t,n]){let s=Yf(i),r=1/0,o=-1/0;for(let a=0;a<i.cellCount;++a){let l=4*a,c=e*s[l]+t*s[l+1]+n*s[l+2];c<r&&(r=c),c>o&&(o=c)}return[r,o]}function mh(i,e){let t=new Uint8Array(i.vertexCount);for(let n=0;n<i.cellCount;++n)if(e.of[n]===Ia)for(let s=i.first[n];s<i.first[n+1];++s)t[i.vertices[s]]=1;return t}function $f(i){let e=Object.freeze({...i}),t=new Set;return{get:()=>e,set(n){let s=new Set(Object.keys(n).filter(r=>!Object.is(n[r],e[r])));if(s.size!==0){e=Object.freeze({...e,...n});for(let r of[...t])r(e,s)}},on(n,s){let r=(o,a)=>{n.some(l=>a.has(l))&&s(o)};return t.add(r),s(e),()=>t.delete(r)}}}function Zf(i){let e=i.dimension===2;return{mode:i.after?"side":"single",wipe:.5,scrub:i.stops.length-1,metric:i.metrics[0]?.name??null,values:null,range:null,rangeOf:i.after?"after":"before",show:"all",others:i.type==="volume"?"hide":"fade",cutAxis:"off",cutNormal:null,cutPlace:.5,cutFlip:!1,shrink:1,edges:!0,features:!e,marks:!1,vectors:!1,vectorScale:1,selected:-1,hovered:-1,visible:null}}var md=0,Yh=1,gd=2;var Yo=1,_d=2,Yr=3,ji=0,In=1,Bi=2,ki=0,Ys=1,$h=2,Zh=3,Jh=4,xd=5;var Ms=100,vd=101,yd=102,Md=103,bd=104,Sd=200,wd=201,Ad=202,Td=203,tl=204,nl=205,Ed=206,Cd=207,Rd=208,Id=209,Pd=210,Ld=211,Dd=212,Nd=213,Fd=214,il=0,sl=1,rl=2,$s=3,ol=4,al=5,ll=6,cl=7,Kh=0,Ud=1,Od=2,mi=0,jh=1,Qh=2,eu=3,tu=4,nu=5,iu=6,su=7;var ru=300,Rs=301,Ks=302,Dl=303,Nl=304,$o=306,hl=1e3,Ni=1001,ul=1002,Qt=1003,Bd=1004;var Zo=1005;var gn=1006,Fl=1007;var Is=1008;var bn=1009,ou=1010,au=1011,$r=1012,Ul=1013,gi=1014,Zn=1015,zi=1016,Ol=1017,Bl=1018,Zr=1020,lu=35902,cu=35899,hu=1021,uu=1022,Pn=1023,Fi=1026,Ps=1027,fu=1028,kl=1029,js=1030,zl=1031;var Jr=1033,Jo=33776,Ko=33777,jo=33778,Qo=33779,Vl=35840,Gl=35841,Hl=35842,Wl=35843,Xl=36196,ql=37492,Yl=37496,$l=37488,Zl=37489,Jl=37490,Kl=37491,jl=37808,Ql=37809,ec=37810,tc=37811,nc=37812,ic=37813,sc=37814,rc=37815,oc=37816,ac=37817,lc=37818,cc=37819,hc=37820,uc=37821,fc=36492,dc=36494,pc=36495,mc=36283,gc=36284,_c=36285,xc=36286;var Co=2300,fl=2301,el=2302,kh=2303,zh=2400,Vh=2401,Gh=2402;var kd=3200;var zd=0,Vd=1,ts="",Xn="srgb",Zs="srgb-linear",Ro="linear",St="srgb";var Xs=7680;var Hh=519,Gd=512,Hd=513,Wd=514,vc=515,Xd=516,qd=517,yc=518,Yd=519,Wh=35044;var ea="300 es",pi=2e3,Io=2001;function g0(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function _0(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Po(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function $d(){let i=Po("canvas");return i.style.display="block",i}var Jf={},zr=null;function du(...i){let e="THREE."+i.shift();zr?zr("log",e,...i):console.log(e,...i)}function Zd(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function qe(...i){i=Zd(i);let e="THREE."+i.shift();if(zr)zr("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function Xe(...i){i=Zd(i);let e="THREE."+i.shift();if(zr)zr("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Lo(...i){let e=i.join(" ");e in Jf||(Jf[e]=!0,qe(...i))}function Jd(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Kd={[il]:sl,[rl]:ll,[ol]:cl,[$s]:al,[sl]:il,[ll]:rl,[cl]:ol,[al]:$s},Qi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},vn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var gh=Math.PI/180,dl=180/Math.PI;function ta(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(vn[i&255]+vn[i>>8&255]+vn[i>>16&255]+vn[i>>24&255]+"-"+vn[e&255]+vn[e>>8&255]+"-"+vn[e>>16&15|64]+vn[e>>24&255]+"-"+vn[t&63|128]+vn[t>>8&255]+"-"+vn[t>>16&255]+vn[t>>24&255]+vn[n&255]+vn[n>>8&255]+vn[n>>16&255]+vn[n>>24&255]).toLowerCase()}function ct(i,e,t){return Math.max(e,Math.min(t,i))}function x0(i,e){return(i%e+e)%e}function _h(i,e,t){return(1-t)*i+t*e}function So(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Fn(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var Mt=class i{constructor(e=0,t=0){i.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ct(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ct(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ui=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],f=n[s+3],u=r[o+0],d=r[o+1],g=r[o+2],M=r[o+3];if(f!==M||l!==u||c!==d||h!==g){let p=l*u+c*d+h*g+f*M;p<0&&(u=-u,d=-d,g=-g,M=-M,p=-p);let m=1-a;if(p<.9995){let y=Math.acos(p),A=Math.sin(y);m=Math.sin(m*y)/A,a=Math.sin(a*y)/A,l=l*m+u*a,c=c*m+d*a,h=h*m+g*a,f=f*m+M*a}else{l=l*m+u*a,c=c*m+d*a,h=h*m+g*a,f=f*m+M*a;let y=1/Math.sqrt(l*l+c*c+h*h+f*f);l*=y,c*=y,h*=y,f*=y}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=f}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],f=r[o],u=r[o+1],d=r[o+2],g=r[o+3];return e[t]=a*g+h*f+l*d-c*u,e[t+1]=l*g+h*u+c*f-a*d,e[t+2]=c*g+h*d+a*u-l*f,e[t+3]=h*g-a*f-l*u-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),f=a(r/2),u=l(n/2),d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=u*h*f+c*d*g,this._y=c*d*f-u*h*g,this._z=c*h*g+u*d*f,this._w=c*h*f-u*d*g;break;case"YXZ":this._x=u*h*f+c*d*g,this._y=c*d*f-u*h*g,this._z=c*h*g-u*d*f,this._w=c*h*f+u*d*g;break;case"ZXY":this._x=u*h*f-c*d*g,this._y=c*d*f+u*h*g,this._z=c*h*g+u*d*f,this._w=c*h*f-u*d*g;break;case"ZYX":this._x=u*h*f-c*d*g,this._y=c*d*f+u*h*g,this._z=c*h*g-u*d*f,this._w=c*h*f+u*d*g;break;case"YZX":this._x=u*h*f+c*d*g,this._y=c*d*f+u*h*g,this._z=c*h*g-u*d*f,this._w=c*h*f-u*d*g;break;case"XZY":this._x=u*h*f-c*d*g,this._y=c*d*f-u*h*g,this._z=c*h*g+u*d*f,this._w=c*h*f+u*d*g;break;default:qe("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],f=t[10],u=n+a+f;if(u>0){let d=.5/Math.sqrt(u+1);this._w=.25/d,this._x=(h-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>f){let d=2*Math.sqrt(1+n-a-f);this._w=(h-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>f){let d=2*Math.sqrt(1+a-n-f);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+h)/d}else{let d=2*Math.sqrt(1+f-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ct(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},Z=class i{constructor(e=0,t=0,n=0){i.prototype.isVector3=!0,this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Kf.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Kf.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),f=2*(r*n-o*t);return this.x=t+l*c+o*f-a*h,this.y=n+l*h+a*c-r*f,this.z=s+l*f+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ct(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return xh.copy(this).projectOnVector(e),this.sub(xh)}reflect(e){return this.sub(xh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ct(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},xh=new Z,Kf=new Ui,nt=class i{constructor(e,t,n,s,r,o,a,l,c){i.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],f=n[7],u=n[2],d=n[5],g=n[8],M=s[0],p=s[3],m=s[6],y=s[1],A=s[4],w=s[7],D=s[2],R=s[5],N=s[8];return r[0]=o*M+a*y+l*D,r[3]=o*p+a*A+l*R,r[6]=o*m+a*w+l*N,r[1]=c*M+h*y+f*D,r[4]=c*p+h*A+f*R,r[7]=c*m+h*w+f*N,r[2]=u*M+d*y+g*D,r[5]=u*p+d*A+g*R,r[8]=u*m+d*w+g*N,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],f=h*o-a*c,u=a*l-h*r,d=c*r-o*l,g=t*f+n*u+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let M=1/g;return e[0]=f*M,e[1]=(s*c-h*n)*M,e[2]=(a*n-s*o)*M,e[3]=u*M,e[4]=(h*t-s*l)*M,e[5]=(s*r-a*t)*M,e[6]=d*M,e[7]=(n*l-c*t)*M,e[8]=(o*t-n*r)*M,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(vh.makeScale(e,t)),this}rotate(e){return this.premultiply(vh.makeRotation(-e)),this}translate(e,t){return this.premultiply(vh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},vh=new nt,jf=new nt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Qf=new nt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function v0(){let i={enabled:!0,workingColorSpace:Zs,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===St&&(s.r=Ki(s.r),s.g=Ki(s.g),s.b=Ki(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===St&&(s.r=kr(s.r),s.g=kr(s.g),s.b=kr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ts?Ro:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return Lo("ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),i.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return Lo("ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),i.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Zs]:{primaries:e,whitePoint:n,transfer:Ro,toXYZ:jf,fromXYZ:Qf,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Xn},outputColorSpaceConfig:{drawingBufferColorSpace:Xn}},[Xn]:{primaries:e,whitePoint:n,transfer:St,toXYZ:jf,fromXYZ:Qf,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Xn}}}),i}var ut=v0();function Ki(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function kr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Er,pl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Er===void 0&&(Er=Po("canvas")),Er.width=e.width,Er.height=e.height;let s=Er.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Er}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Po("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ki(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Ki(t[n]/255)*255):t[n]=Ki(t[n]);return{data:t,width:e.width,height:e.height}}else return qe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},y0=0,Vr=class{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:y0++}),this.uuid=ta(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayHeight,t.displayWidth,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(yh(s[o].image)):r.push(yh(s[o]))}else r=yh(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function yh(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?pl.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(qe("Texture: Unable to serialize Texture."),{})}var M0=0,Mh=new Z,On=class i extends Qi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Ni,s=Ni,r=gn,o=Is,a=Pn,l=bn,c=i.DEFAULT_ANISOTROPY,h=ts){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:M0++}),this.uuid=ta(),this.name="",this.source=new Vr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Mt(0,0),this.repeat=new Mt(1,1),this.center=new Mt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new nt,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(Mh).x}get height(){return this.source.getSize(Mh).y}get depth(){return this.source.getSize(Mh).z}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){qe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){qe(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==ru)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case hl:e.x=e.x-Math.floor(e.x);break;case Ni:e.x=e.x<0?0:1;break;case ul:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case hl:e.y=e.y-Math.floor(e.y);break;case Ni:e.y=e.y<0?0:1;break;case ul:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};On.DEFAULT_IMAGE=null;On.DEFAULT_MAPPING=ru;On.DEFAULT_ANISOTROPY=1;var Yt=class i{constructor(e=0,t=0,n=0,s=1){i.prototype.isVector4=!0,this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],f=l[8],u=l[1],d=l[5],g=l[9],M=l[2],p=l[6],m=l[10];if(Math.abs(h-u)<.01&&Math.abs(f-M)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+u)<.1&&Math.abs(f+M)<.1&&Math.abs(g+p)<.1&&Math.abs(c+d+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(c+1)/2,w=(d+1)/2,D=(m+1)/2,R=(h+u)/4,N=(f+M)/4,v=(g+p)/4;return A>w&&A>D?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=R/n,r=N/n):w>D?w<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(w),n=R/s,r=v/s):D<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(D),n=N/r,s=v/r),this.set(n,s,r,t),this}let y=Math.sqrt((p-g)*(p-g)+(f-M)*(f-M)+(u-h)*(u-h));return Math.abs(y)<.001&&(y=1),this.x=(p-g)/y,this.y=(f-M)/y,this.z=(u-h)/y,this.w=Math.acos((c+d+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this.w=ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this.w=ct(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ct(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ml=class extends Qi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:gn,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Yt(0,0,e,t),this.scissorTest=!1,this.viewport=new Yt(0,0,e,t),this.textures=[];let s={width:e,height:t,depth:n.depth},r=new On(s),o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview}_setTextureOptions(e={}){let t={minFilter:gn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Vr(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Rn=class extends ml{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Do=class extends On{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Qt,this.minFilter=Qt,this.wrapR=Ni,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var gl=class extends On{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Qt,this.minFilter=Qt,this.wrapR=Ni,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var $t=class i{constructor(e,t,n,s,r,o,a,l,c,h,f,u,d,g,M,p){i.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,f,u,d,g,M,p)}set(e,t,n,s,r,o,a,l,c,h,f,u,d,g,M,p){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=f,m[14]=u,m[3]=d,m[7]=g,m[11]=M,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinant()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinant()===0)return this.identity();let t=this.elements,n=e.elements,s=1/Cr.setFromMatrixColumn(e,0).length(),r=1/Cr.setFromMatrixColumn(e,1).length(),o=1/Cr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let u=o*h,d=o*f,g=a*h,M=a*f;t[0]=l*h,t[4]=-l*f,t[8]=c,t[1]=d+g*c,t[5]=u-M*c,t[9]=-a*l,t[2]=M-u*c,t[6]=g+d*c,t[10]=o*l}else if(e.order==="YXZ"){let u=l*h,d=l*f,g=c*h,M=c*f;t[0]=u+M*a,t[4]=g*a-d,t[8]=o*c,t[1]=o*f,t[5]=o*h,t[9]=-a,t[2]=d*a-g,t[6]=M+u*a,t[10]=o*l}else if(e.order==="ZXY"){let u=l*h,d=l*f,g=c*h,M=c*f;t[0]=u-M*a,t[4]=-o*f,t[8]=g+d*a,t[1]=d+g*a,t[5]=o*h,t[9]=M-u*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let u=o*h,d=o*f,g=a*h,M=a*f;t[0]=l*h,t[4]=g*c-d,t[8]=u*c+M,t[1]=l*f,t[5]=M*c+u,t[9]=d*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let u=o*l,d=o*c,g=a*l,M=a*c;t[0]=l*h,t[4]=M-u*f,t[8]=g*f+d,t[1]=f,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=d*f+g,t[10]=u-M*f}else if(e.order==="XZY"){let u=o*l,d=o*c,g=a*l,M=a*c;t[0]=l*h,t[4]=-f,t[8]=c*h,t[1]=u*f+M,t[5]=o*h,t[9]=d*f-g,t[2]=g*f-d,t[6]=a*h,t[10]=M*f+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(b0,e,S0)}lookAt(e,t,n){let s=this.elements;return Hn.subVectors(e,t),Hn.lengthSq()===0&&(Hn.z=1),Hn.normalize(),ps.crossVectors(n,Hn),ps.lengthSq()===0&&(Math.abs(n.z)===1?Hn.x+=1e-4:Hn.z+=1e-4,Hn.normalize(),ps.crossVectors(n,Hn)),ps.normalize(),La.crossVectors(Hn,ps),s[0]=ps.x,s[4]=La.x,s[8]=Hn.x,s[1]=ps.y,s[5]=La.y,s[9]=Hn.y,s[2]=ps.z,s[6]=La.z,s[10]=Hn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],f=n[5],u=n[9],d=n[13],g=n[2],M=n[6],p=n[10],m=n[14],y=n[3],A=n[7],w=n[11],D=n[15],R=s[0],N=s[4],v=s[8],T=s[12],q=s[1],E=s[5],G=s[9],O=s[13],W=s[2],V=s[6],H=s[10],U=s[14],le=s[3],ie=s[7],ce=s[11],_e=s[15];return r[0]=o*R+a*q+l*W+c*le,r[4]=o*N+a*E+l*V+c*ie,r[8]=o*v+a*G+l*H+c*ce,r[12]=o*T+a*O+l*U+c*_e,r[1]=h*R+f*q+u*W+d*le,r[5]=h*N+f*E+u*V+d*ie,r[9]=h*v+f*G+u*H+d*ce,r[13]=h*T+f*O+u*U+d*_e,r[2]=g*R+M*q+p*W+m*le,r[6]=g*N+M*E+p*V+m*ie,r[10]=g*v+M*G+p*H+m*ce,r[14]=g*T+M*O+p*U+m*_e,r[3]=y*R+A*q+w*W+D*le,r[7]=y*N+A*E+w*V+D*ie,r[11]=y*v+A*G+w*H+D*ce,r[15]=y*T+A*O+w*U+D*_e,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],f=e[6],u=e[10],d=e[14],g=e[3],M=e[7],p=e[11],m=e[15],y=l*d-c*u,A=a*d-c*f,w=a*u-l*f,D=o*d-c*h,R=o*u-l*h,N=o*f-a*h;return t*(M*y-p*A+m*w)-n*(g*y-p*D+m*R)+s*(g*A-M*D+m*N)-r*(g*w-M*R+p*N)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],f=e[9],u=e[10],d=e[11],g=e[12],M=e[13],p=e[14],m=e[15],y=t*a-n*o,A=t*l-s*o,w=t*c-r*o,D=n*l-s*a,R=n*c-r*a,N=s*c-r*l,v=h*M-f*g,T=h*p-u*g,q=h*m-d*g,E=f*p-u*M,G=f*m-d*M,O=u*m-d*p,W=y*O-A*G+w*E+D*q-R*T+N*v;if(W===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/W;return e[0]=(a*O-l*G+c*E)*V,e[1]=(s*G-n*O-r*E)*V,e[2]=(M*N-p*R+m*D)*V,e[3]=(u*R-f*N-d*D)*V,e[4]=(l*q-o*O-c*T)*V,e[5]=(t*O-s*q+r*T)*V,e[6]=(p*w-g*N-m*A)*V,e[7]=(h*N-u*w+d*A)*V,e[8]=(o*G-a*q+c*v)*V,e[9]=(n*q-t*G-r*v)*V,e[10]=(g*R-M*w+m*y)*V,e[11]=(f*w-h*R-d*y)*V,e[12]=(a*T-o*E-l*v)*V,e[13]=(t*E-n*T+s*v)*V,e[14]=(M*A-g*D-p*y)*V,e[15]=(h*D-f*A+u*y)*V,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,f=a+a,u=r*c,d=r*h,g=r*f,M=o*h,p=o*f,m=a*f,y=l*c,A=l*h,w=l*f,D=n.x,R=n.y,N=n.z;return s[0]=(1-(M+m))*D,s[1]=(d+w)*D,s[2]=(g-A)*D,s[3]=0,s[4]=(d-w)*R,s[5]=(1-(u+m))*R,s[6]=(p+y)*R,s[7]=0,s[8]=(g+A)*N,s[9]=(p-y)*N,s[10]=(1-(u+M))*N,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinant();if(r===0)return n.set(1,1,1),t.identity(),this;let o=Cr.set(s[0],s[1],s[2]).length(),a=Cr.set(s[4],s[5],s[6]).length(),l=Cr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),ui.copy(this);let c=1/o,h=1/a,f=1/l;return ui.elements[0]*=c,ui.elements[1]*=c,ui.elements[2]*=c,ui.elements[4]*=h,ui.elements[5]*=h,ui.elements[6]*=h,ui.elements[8]*=f,ui.elements[9]*=f,ui.elements[10]*=f,t.setFromRotationMatrix(ui),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=pi,l=!1){let c=this.elements,h=2*r/(t-e),f=2*r/(n-s),u=(t+e)/(t-e),d=(n+s)/(n-s),g,M;if(l)g=r/(o-r),M=o*r/(o-r);else if(a===pi)g=-(o+r)/(o-r),M=-2*o*r/(o-r);else if(a===Io)g=-o/(o-r),M=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=M,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=pi,l=!1){let c=this.elements,h=2/(t-e),f=2/(n-s),u=-(t+e)/(t-e),d=-(n+s)/(n-s),g,M;if(l)g=1/(o-r),M=o/(o-r);else if(a===pi)g=-2/(o-r),M=-(o+r)/(o-r);else if(a===Io)g=-1/(o-r),M=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=g,c[14]=M,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Cr=new Z,ui=new $t,b0=new Z(0,0,0),S0=new Z(1,1,1),ps=new Z,La=new Z,Hn=new Z,ed=new $t,td=new Ui,Oi=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],f=s[2],u=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ct(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(ct(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ct(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(u,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ct(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,d),this._y=0);break;default:qe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return ed.makeRotationFromQuaternion(e),this.setFromRotationMatrix(ed,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return td.setFromEuler(this),this.setFromQuaternion(td,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Oi.DEFAULT_ORDER="XYZ";var No=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},w0=0,nd=new Z,Rr=new Ui,qi=new $t,Da=new Z,wo=new Z,A0=new Z,T0=new Ui,id=new Z(1,0,0),sd=new Z(0,1,0),rd=new Z(0,0,1),od={type:"added"},E0={type:"removed"},Ir={type:"childadded",child:null},bh={type:"childremoved",child:null},qn=class i extends Qi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:w0++}),this.uuid=ta(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new Z,t=new Oi,n=new Ui,s=new Z(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new $t},normalMatrix:{value:new nt}}),this.matrix=new $t,this.matrixWorld=new $t,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new No,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Rr.setFromAxisAngle(e,t),this.quaternion.multiply(Rr),this}rotateOnWorldAxis(e,t){return Rr.setFromAxisAngle(e,t),this.quaternion.premultiply(Rr),this}rotateX(e){return this.rotateOnAxis(id,e)}rotateY(e){return this.rotateOnAxis(sd,e)}rotateZ(e){return this.rotateOnAxis(rd,e)}translateOnAxis(e,t){return nd.copy(e).applyQuaternion(this.quaternion),this.position.add(nd.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(id,e)}translateY(e){return this.translateOnAxis(sd,e)}translateZ(e){return this.translateOnAxis(rd,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(qi.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Da.copy(e):Da.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),wo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?qi.lookAt(wo,Da,this.up):qi.lookAt(Da,wo,this.up),this.quaternion.setFromRotationMatrix(qi),s&&(qi.extractRotation(s.matrixWorld),Rr.setFromRotationMatrix(qi),this.quaternion.premultiply(Rr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Xe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(od),Ir.child=e,this.dispatchEvent(Ir),Ir.child=null):Xe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(E0),bh.child=e,this.dispatchEvent(bh),bh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),qi.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),qi.multiply(e.parent.matrixWorld)),e.applyMatrix4(qi),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(od),Ir.child=e,this.dispatchEvent(Ir),Ir.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(wo,e,A0),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(wo,T0,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t){let n=this.parent;if(e===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),this.static!==!1&&(s.static=this.static),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),f=o(e.shapes),u=o(e.skeletons),d=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),f.length>0&&(n.shapes=f),u.length>0&&(n.skeletons=u),d.length>0&&(n.animations=d),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),e.pivot!==null&&(this.pivot=e.pivot.clone()),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}};qn.DEFAULT_UP=new Z(0,1,0);qn.DEFAULT_MATRIX_AUTO_UPDATE=!0;qn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var qs=class extends qn{constructor(){super(),this.isGroup=!0,this.type="Group"}},C0={type:"move"},Gr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new qs,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new qs,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new Z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new Z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new qs,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new Z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new Z),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let M of e.hand.values()){let p=t.getJointPose(M,n),m=this._getHandJoint(c,M);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.rotation,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let h=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],u=h.position.distanceTo(f.position),d=.02,g=.005;c.inputState.pinching&&u>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&u<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(C0)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new qs;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},jd={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ms={h:0,s:0,l:0},Na={h:0,s:0,l:0};function Sh(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var ft=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Xn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,ut.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=ut.workingColorSpace){return this.r=e,this.g=t,this.b=n,ut.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=ut.workingColorSpace){if(e=x0(e,1),t=ct(t,0,1),n=ct(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Sh(o,r,e+1/3),this.g=Sh(o,r,e),this.b=Sh(o,r,e-1/3)}return ut.colorSpaceToWorking(this,s),this}setStyle(e,t=Xn){function n(r){r!==void 0&&parseFloat(r)<1&&qe("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:qe("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);qe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Xn){let n=jd[e.toLowerCase()];return n!==void 0?this.setHex(n,t):qe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ki(e.r),this.g=Ki(e.g),this.b=Ki(e.b),this}copyLinearToSRGB(e){return this.r=kr(e.r),this.g=kr(e.g),this.b=kr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Xn){return ut.workingToColorSpace(yn.copy(this),e),Math.round(ct(yn.r*255,0,255))*65536+Math.round(ct(yn.g*255,0,255))*256+Math.round(ct(yn.b*255,0,255))}getHexString(e=Xn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=ut.workingColorSpace){ut.workingToColorSpace(yn.copy(this),t);let n=yn.r,s=yn.g,r=yn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=h<=.5?f/(o+a):f/(2-o-a),o){case n:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-n)/f+2;break;case r:l=(n-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=ut.workingColorSpace){return ut.workingToColorSpace(yn.copy(this),t),e.r=yn.r,e.g=yn.g,e.b=yn.b,e}getStyle(e=Xn){ut.workingToColorSpace(yn.copy(this),e);let t=yn.r,n=yn.g,s=yn.b;return e!==Xn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(ms),this.setHSL(ms.h+e,ms.s+t,ms.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(ms),e.getHSL(Na);let n=_h(ms.h,Na.h,t),s=_h(ms.s,Na.s,t),r=_h(ms.l,Na.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},yn=new ft;ft.NAMES=jd;var Hr=class extends qn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Oi,this.environmentIntensity=1,this.environmentRotation=new Oi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}},fi=new Z,Yi=new Z,wh=new Z,$i=new Z,Pr=new Z,Lr=new Z,ad=new Z,Ah=new Z,Th=new Z,Eh=new Z,Ch=new Yt,Rh=new Yt,Ih=new Yt,ys=class i{constructor(e=new Z,t=new Z,n=new Z){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),fi.subVectors(e,t),s.cross(fi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){fi.subVectors(s,t),Yi.subVectors(n,t),wh.subVectors(e,t);let o=fi.dot(fi),a=fi.dot(Yi),l=fi.dot(wh),c=Yi.dot(Yi),h=Yi.dot(wh),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let u=1/f,d=(c*l-a*h)*u,g=(o*h-a*l)*u;return r.set(1-d-g,g,d)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,$i)===null?!1:$i.x>=0&&$i.y>=0&&$i.x+$i.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,$i)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,$i.x),l.addScaledVector(o,$i.y),l.addScaledVector(a,$i.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Ch.setScalar(0),Rh.setScalar(0),Ih.setScalar(0),Ch.fromBufferAttribute(e,t),Rh.fromBufferAttribute(e,n),Ih.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Ch,r.x),o.addScaledVector(Rh,r.y),o.addScaledVector(Ih,r.z),o}static isFrontFacing(e,t,n,s){return fi.subVectors(n,t),Yi.subVectors(e,t),fi.cross(Yi).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return fi.subVectors(this.c,this.b),Yi.subVectors(this.a,this.b),fi.cross(Yi).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Pr.subVectors(s,n),Lr.subVectors(r,n),Ah.subVectors(e,n);let l=Pr.dot(Ah),c=Lr.dot(Ah);if(l<=0&&c<=0)return t.copy(n);Th.subVectors(e,s);let h=Pr.dot(Th),f=Lr.dot(Th);if(h>=0&&f<=h)return t.copy(s);let u=l*f-h*c;if(u<=0&&l>=0&&h<=0)return o=l/(l-h),t.copy(n).addScaledVector(Pr,o);Eh.subVectors(e,r);let d=Pr.dot(Eh),g=Lr.dot(Eh);if(g>=0&&d<=g)return t.copy(r);let M=d*c-l*g;if(M<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(Lr,a);let p=h*g-d*f;if(p<=0&&f-h>=0&&d-g>=0)return ad.subVectors(r,s),a=(f-h)/(f-h+(d-g)),t.copy(s).addScaledVector(ad,a);let m=1/(p+M+u);return o=M*m,a=u*m,t.copy(n).addScaledVector(Pr,o).addScaledVector(Lr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},bs=class{constructor(e=new Z(1/0,1/0,1/0),t=new Z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(di.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(di.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=di.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,di):di.fromBufferAttribute(r,o),di.applyMatrix4(e.matrixWorld),this.expandByPoint(di);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Fa.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Fa.copy(n.boundingBox)),Fa.applyMatrix4(e.matrixWorld),this.union(Fa)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,di),di.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ao),Ua.subVectors(this.max,Ao),Dr.subVectors(e.a,Ao),Nr.subVectors(e.b,Ao),Fr.subVectors(e.c,Ao),gs.subVectors(Nr,Dr),_s.subVectors(Fr,Nr),Vs.subVectors(Dr,Fr);let t=[0,-gs.z,gs.y,0,-_s.z,_s.y,0,-Vs.z,Vs.y,gs.z,0,-gs.x,_s.z,0,-_s.x,Vs.z,0,-Vs.x,-gs.y,gs.x,0,-_s.y,_s.x,0,-Vs.y,Vs.x,0];return!Ph(t,Dr,Nr,Fr,Ua)||(t=[1,0,0,0,1,0,0,0,1],!Ph(t,Dr,Nr,Fr,Ua))?!1:(Oa.crossVectors(gs,_s),t=[Oa.x,Oa.y,Oa.z],Ph(t,Dr,Nr,Fr,Ua))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,di).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(di).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Zi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Zi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Zi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Zi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Zi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Zi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Zi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Zi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Zi),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Zi=[new Z,new Z,new Z,new Z,new Z,new Z,new Z,new Z],di=new Z,Fa=new bs,Dr=new Z,Nr=new Z,Fr=new Z,gs=new Z,_s=new Z,Vs=new Z,Ao=new Z,Ua=new Z,Oa=new Z,Gs=new Z;function Ph(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Gs.fromArray(i,r);let a=s.x*Math.abs(Gs.x)+s.y*Math.abs(Gs.y)+s.z*Math.abs(Gs.z),l=e.dot(Gs),c=t.dot(Gs),h=n.dot(Gs);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var jt=new Z,Ba=new Mt,R0=0,mn=class{constructor(e,t,n=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:R0++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Wh,this.updateRanges=[],this.gpuType=Zn,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Ba.fromBufferAttribute(this,t),Ba.applyMatrix3(e),this.setXY(t,Ba.x,Ba.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)jt.fromBufferAttribute(this,t),jt.applyMatrix3(e),this.setXYZ(t,jt.x,jt.y,jt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)jt.fromBufferAttribute(this,t),jt.applyMatrix4(e),this.setXYZ(t,jt.x,jt.y,jt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)jt.fromBufferAttribute(this,t),jt.applyNormalMatrix(e),this.setXYZ(t,jt.x,jt.y,jt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)jt.fromBufferAttribute(this,t),jt.transformDirection(e),this.setXYZ(t,jt.x,jt.y,jt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=So(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=Fn(n,this.array)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=So(t,this.array)),t}setX(e,t){return this.normalized&&(t=Fn(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=So(t,this.array)),t}setY(e,t){return this.normalized&&(t=Fn(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=So(t,this.array)),t}setZ(e,t){return this.normalized&&(t=Fn(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=So(t,this.array)),t}setW(e,t){return this.normalized&&(t=Fn(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=Fn(t,this.array),n=Fn(n,this.array)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=Fn(t,this.array),n=Fn(n,this.array),s=Fn(s,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=Fn(t,this.array),n=Fn(n,this.array),s=Fn(s,this.array),r=Fn(r,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==Wh&&(e.usage=this.usage),e}};var Fo=class extends mn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Uo=class extends mn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var ri=class extends mn{constructor(e,t,n){super(new Float32Array(e),t,n)}},I0=new bs,To=new Z,Lh=new Z,es=class{constructor(e=new Z,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):I0.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;To.subVectors(e,this.center);let t=To.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(To,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Lh.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(To.copy(e.center).add(Lh)),this.expandByPoint(To.copy(e.center).sub(Lh))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},P0=0,si=new $t,Dh=new qn,Ur=new Z,Wn=new bs,Eo=new bs,fn=new Z,_n=class i extends Qi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:P0++}),this.uuid=ta(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(g0(e)?Uo:Fo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new nt().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return si.makeRotationFromQuaternion(e),this.applyMatrix4(si),this}rotateX(e){return si.makeRotationX(e),this.applyMatrix4(si),this}rotateY(e){return si.makeRotationY(e),this.applyMatrix4(si),this}rotateZ(e){return si.makeRotationZ(e),this.applyMatrix4(si),this}translate(e,t,n){return si.makeTranslation(e,t,n),this.applyMatrix4(si),this}scale(e,t,n){return si.makeScale(e,t,n),this.applyMatrix4(si),this}lookAt(e){return Dh.lookAt(e),Dh.updateMatrix(),this.applyMatrix4(Dh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ur).negate(),this.translate(Ur.x,Ur.y,Ur.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ri(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&qe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new bs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Xe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new Z(-1/0,-1/0,-1/0),new Z(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];Wn.setFromBufferAttribute(r),this.morphTargetsRelative?(fn.addVectors(this.boundingBox.min,Wn.min),this.boundingBox.expandByPoint(fn),fn.addVectors(this.boundingBox.max,Wn.max),this.boundingBox.expandByPoint(fn)):(this.boundingBox.expandByPoint(Wn.min),this.boundingBox.expandByPoint(Wn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Xe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new es);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Xe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new Z,1/0);return}if(e){let n=this.boundingSphere.center;if(Wn.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Eo.setFromBufferAttribute(a),this.morphTargetsRelative?(fn.addVectors(Wn.min,Eo.min),Wn.expandByPoint(fn),fn.addVectors(Wn.max,Eo.max),Wn.expandByPoint(fn)):(Wn.expandByPoint(Eo.min),Wn.expandByPoint(Eo.max))}Wn.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)fn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(fn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)fn.fromBufferAttribute(a,c),l&&(Ur.fromBufferAttribute(e,c),fn.add(Ur)),s=Math.max(s,n.distanceToSquared(fn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Xe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Xe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new mn(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let v=0;v<n.count;v++)a[v]=new Z,l[v]=new Z;let c=new Z,h=new Z,f=new Z,u=new Mt,d=new Mt,g=new Mt,M=new Z,p=new Z;function m(v,T,q){c.fromBufferAttribute(n,v),h.fromBufferAttribute(n,T),f.fromBufferAttribute(n,q),u.fromBufferAttribute(r,v),d.fromBufferAttribute(r,T),g.fromBufferAttribute(r,q),h.sub(c),f.sub(c),d.sub(u),g.sub(u);let E=1/(d.x*g.y-g.x*d.y);isFinite(E)&&(M.copy(h).multiplyScalar(g.y).addScaledVector(f,-d.y).multiplyScalar(E),p.copy(f).multiplyScalar(d.x).addScaledVector(h,-g.x).multiplyScalar(E),a[v].add(M),a[T].add(M),a[q].add(M),l[v].add(p),l[T].add(p),l[q].add(p))}let y=this.groups;y.length===0&&(y=[{start:0,count:e.count}]);for(let v=0,T=y.length;v<T;++v){let q=y[v],E=q.start,G=q.count;for(let O=E,W=E+G;O<W;O+=3)m(e.getX(O+0),e.getX(O+1),e.getX(O+2))}let A=new Z,w=new Z,D=new Z,R=new Z;function N(v){D.fromBufferAttribute(s,v),R.copy(D);let T=a[v];A.copy(T),A.sub(D.multiplyScalar(D.dot(T))).normalize(),w.crossVectors(R,T);let E=w.dot(l[v])<0?-1:1;o.setXYZW(v,A.x,A.y,A.z,E)}for(let v=0,T=y.length;v<T;++v){let q=y[v],E=q.start,G=q.count;for(let O=E,W=E+G;O<W;O+=3)N(e.getX(O+0)),N(e.getX(O+1)),N(e.getX(O+2))}}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new mn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let u=0,d=n.count;u<d;u++)n.setXYZ(u,0,0,0);let s=new Z,r=new Z,o=new Z,a=new Z,l=new Z,c=new Z,h=new Z,f=new Z;if(e)for(let u=0,d=e.count;u<d;u+=3){let g=e.getX(u+0),M=e.getX(u+1),p=e.getX(u+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,M),o.fromBufferAttribute(t,p),h.subVectors(o,r),f.subVectors(s,r),h.cross(f),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,M),c.fromBufferAttribute(n,p),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(M,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let u=0,d=t.count;u<d;u+=3)s.fromBufferAttribute(t,u+0),r.fromBufferAttribute(t,u+1),o.fromBufferAttribute(t,u+2),h.subVectors(o,r),f.subVectors(s,r),h.cross(f),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)fn.fromBufferAttribute(e,t),fn.normalize(),e.setXYZ(t,fn.x,fn.y,fn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,f=a.normalized,u=new c.constructor(l.length*h),d=0,g=0;for(let M=0,p=l.length;M<p;M++){a.isInterleavedBufferAttribute?d=l[M]*a.data.stride+a.offset:d=l[M]*h;for(let m=0;m<h;m++)u[g++]=c[d++]}return new mn(u,h,f)}if(this.index===null)return qe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,f=c.length;h<f;h++){let u=c[h],d=e(u,n);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let f=0,u=c.length;f<u;f++){let d=c[f];h.push(d.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],f=r[c];for(let u=0,d=f.length;u<d;u++)h.push(f[u].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}};var L0=0,Ss=class extends Qi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:L0++}),this.uuid=ta(),this.name="",this.type="Material",this.blending=Ys,this.side=ji,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=tl,this.blendDst=nl,this.blendEquation=Ms,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ft(0,0,0),this.blendAlpha=0,this.depthFunc=$s,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Hh,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Xs,this.stencilZFail=Xs,this.stencilZPass=Xs,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){qe(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){qe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==Ys&&(n.blending=this.blending),this.side!==ji&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==tl&&(n.blendSrc=this.blendSrc),this.blendDst!==nl&&(n.blendDst=this.blendDst),this.blendEquation!==Ms&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==$s&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Hh&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Xs&&(n.stencilFail=this.stencilFail),this.stencilZFail!==Xs&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==Xs&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.allowOverride===!1&&(n.allowOverride=!1),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Ji=new Z,Nh=new Z,ka=new Z,xs=new Z,Fh=new Z,za=new Z,Uh=new Z,Oo=class{constructor(e=new Z,t=new Z(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ji)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Ji.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ji.copy(this.origin).addScaledVector(this.direction,t),Ji.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Nh.copy(e).add(t).multiplyScalar(.5),ka.copy(t).sub(e).normalize(),xs.copy(this.origin).sub(Nh);let r=e.distanceTo(t)*.5,o=-this.direction.dot(ka),a=xs.dot(this.direction),l=-xs.dot(ka),c=xs.lengthSq(),h=Math.abs(1-o*o),f,u,d,g;if(h>0)if(f=o*l-a,u=o*a-l,g=r*h,f>=0)if(u>=-g)if(u<=g){let M=1/h;f*=M,u*=M,d=f*(f+o*u+2*a)+u*(o*f+u+2*l)+c}else u=r,f=Math.max(0,-(o*u+a)),d=-f*f+u*(u+2*l)+c;else u=-r,f=Math.max(0,-(o*u+a)),d=-f*f+u*(u+2*l)+c;else u<=-g?(f=Math.max(0,-(-o*r+a)),u=f>0?-r:Math.min(Math.max(-r,-l),r),d=-f*f+u*(u+2*l)+c):u<=g?(f=0,u=Math.min(Math.max(-r,-l),r),d=u*(u+2*l)+c):(f=Math.max(0,-(o*r+a)),u=f>0?r:Math.min(Math.max(-r,-l),r),d=-f*f+u*(u+2*l)+c);else u=o>0?-r:r,f=Math.max(0,-(o*u+a)),d=-f*f+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Nh).addScaledVector(ka,u),d}intersectSphere(e,t){Ji.subVectors(e.center,this.origin);let n=Ji.dot(this.direction),s=Ji.dot(Ji)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,u=this.origin;return c>=0?(n=(e.min.x-u.x)*c,s=(e.max.x-u.x)*c):(n=(e.max.x-u.x)*c,s=(e.min.x-u.x)*c),h>=0?(r=(e.min.y-u.y)*h,o=(e.max.y-u.y)*h):(r=(e.max.y-u.y)*h,o=(e.min.y-u.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-u.z)*f,l=(e.max.z-u.z)*f):(a=(e.max.z-u.z)*f,l=(e.min.z-u.z)*f),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Ji)!==null}intersectTriangle(e,t,n,s,r){Fh.subVectors(t,e),za.subVectors(n,e),Uh.crossVectors(Fh,za);let o=this.direction.dot(Uh),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;xs.subVectors(this.origin,e);let l=a*this.direction.dot(za.crossVectors(xs,za));if(l<0)return null;let c=a*this.direction.dot(Fh.cross(xs));if(c<0||l+c>o)return null;let h=-a*xs.dot(Uh);return h<0?null:this.at(h/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Bo=class extends Ss{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ft(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Oi,this.combine=Kh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},ld=new $t,Hs=new Oo,Va=new es,cd=new Z,Ga=new Z,Ha=new Z,Wa=new Z,Oh=new Z,Xa=new Z,hd=new Z,qa=new Z,Mn=class extends qn{constructor(e=new _n,t=new Bo){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Xa.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],f=r[l];h!==0&&(Oh.fromBufferAttribute(f,e),o?Xa.addScaledVector(Oh,h):Xa.addScaledVector(Oh.sub(t),h))}t.add(Xa)}return t}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Va.copy(n.boundingSphere),Va.applyMatrix4(r),Hs.copy(e.ray).recast(e.near),!(Va.containsPoint(Hs.origin)===!1&&(Hs.intersectSphere(Va,cd)===null||Hs.origin.distanceToSquared(cd)>(e.far-e.near)**2))&&(ld.copy(r).invert(),Hs.copy(e.ray).applyMatrix4(ld),!(n.boundingBox!==null&&Hs.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Hs)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,f=r.attributes.normal,u=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,M=u.length;g<M;g++){let p=u[g],m=o[p.materialIndex],y=Math.max(p.start,d.start),A=Math.min(a.count,Math.min(p.start+p.count,d.start+d.count));for(let w=y,D=A;w<D;w+=3){let R=a.getX(w),N=a.getX(w+1),v=a.getX(w+2);s=Ya(this,m,e,n,c,h,f,R,N,v),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,d.start),M=Math.min(a.count,d.start+d.count);for(let p=g,m=M;p<m;p+=3){let y=a.getX(p),A=a.getX(p+1),w=a.getX(p+2);s=Ya(this,o,e,n,c,h,f,y,A,w),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,M=u.length;g<M;g++){let p=u[g],m=o[p.materialIndex],y=Math.max(p.start,d.start),A=Math.min(l.count,Math.min(p.start+p.count,d.start+d.count));for(let w=y,D=A;w<D;w+=3){let R=w,N=w+1,v=w+2;s=Ya(this,m,e,n,c,h,f,R,N,v),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,d.start),M=Math.min(l.count,d.start+d.count);for(let p=g,m=M;p<m;p+=3){let y=p,A=p+1,w=p+2;s=Ya(this,o,e,n,c,h,f,y,A,w),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function D0(i,e,t,n,s,r,o,a){let l;if(e.side===In?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===ji,a),l===null)return null;qa.copy(a),qa.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(qa);return c<t.near||c>t.far?null:{distance:c,point:qa.clone(),object:i}}function Ya(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Ga),i.getVertexPosition(l,Ha),i.getVertexPosition(c,Wa);let h=D0(i,e,t,n,Ga,Ha,Wa,hd);if(h){let f=new Z;ys.getBarycoord(hd,Ga,Ha,Wa,f),s&&(h.uv=ys.getInterpolatedAttribute(s,a,l,c,f,new Mt)),r&&(h.uv1=ys.getInterpolatedAttribute(r,a,l,c,f,new Mt)),o&&(h.normal=ys.getInterpolatedAttribute(o,a,l,c,f,new Z),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new Z,materialIndex:0};ys.getNormal(Ga,Ha,Wa,u.normal),h.face=u,h.barycoord=f}return h}var ws=class extends On{constructor(e=null,t=1,n=1,s,r,o,a,l,c=Qt,h=Qt,f,u){super(null,o,a,l,c,h,s,r,f,u),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ko=class extends mn{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var Bh=new Z,N0=new Z,F0=new nt,Di=class{constructor(e=new Z(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Bh.subVectors(n,t).cross(N0.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){let n=e.delta(Bh),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(n,r)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||F0.getNormalMatrix(e),s=this.coplanarPoint(Bh).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}},Ws=new es,U0=new Mt(.5,.5),$a=new Z,zo=class{constructor(e=new Di,t=new Di,n=new Di,s=new Di,r=new Di,o=new Di){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=pi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],f=r[5],u=r[6],d=r[7],g=r[8],M=r[9],p=r[10],m=r[11],y=r[12],A=r[13],w=r[14],D=r[15];if(s[0].setComponents(c-o,d-h,m-g,D-y).normalize(),s[1].setComponents(c+o,d+h,m+g,D+y).normalize(),s[2].setComponents(c+a,d+f,m+M,D+A).normalize(),s[3].setComponents(c-a,d-f,m-M,D-A).normalize(),n)s[4].setComponents(l,u,p,w).normalize(),s[5].setComponents(c-l,d-u,m-p,D-w).normalize();else if(s[4].setComponents(c-l,d-u,m-p,D-w).normalize(),t===pi)s[5].setComponents(c+l,d+u,m+p,D+w).normalize();else if(t===Io)s[5].setComponents(l,u,p,w).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Ws.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Ws.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Ws)}intersectsSprite(e){Ws.center.set(0,0,0);let t=U0.distanceTo(e.center);return Ws.radius=.7071067811865476+t,Ws.applyMatrix4(e.matrixWorld),this.intersectsSphere(Ws)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if($a.x=s.normal.x>0?e.max.x:e.min.x,$a.y=s.normal.y>0?e.max.y:e.min.y,$a.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint($a)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var _l=class extends Ss{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new ft(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},ud=new $t,Xh=new Oo,Za=new es,Ja=new Z,Vo=class extends qn{constructor(e=new _n,t=new _l){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Za.copy(n.boundingSphere),Za.applyMatrix4(s),Za.radius+=r,e.ray.intersectsSphere(Za)===!1)return;ud.copy(s).invert(),Xh.copy(e.ray).applyMatrix4(ud);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,f=n.attributes.position;if(c!==null){let u=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let g=u,M=d;g<M;g++){let p=c.getX(g);Ja.fromBufferAttribute(f,p),fd(Ja,p,l,s,e,t,this)}}else{let u=Math.max(0,o.start),d=Math.min(f.count,o.start+o.count);for(let g=u,M=d;g<M;g++)Ja.fromBufferAttribute(f,g),fd(Ja,g,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function fd(i,e,t,n,s,r,o){let a=Xh.distanceSqToPoint(i);if(a<t){let l=new Z;Xh.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var Go=class extends On{constructor(e=[],t=Rs,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var As=class extends On{constructor(e,t,n=gi,s,r,o,a=Qt,l=Qt,c,h=Fi,f=1){if(h!==Fi&&h!==Ps)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:e,height:t,depth:f};super(u,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Vr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}},xl=class extends As{constructor(e,t=gi,n=Rs,s,r,o=Qt,a=Qt,l,c=Fi){let h={width:e,height:e,depth:1},f=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ho=class extends On{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Wr=class i extends _n{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],f=[],u=0,d=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new ri(c,3)),this.setAttribute("normal",new ri(h,3)),this.setAttribute("uv",new ri(f,2));function g(M,p,m,y,A,w,D,R,N,v,T){let q=w/N,E=D/v,G=w/2,O=D/2,W=R/2,V=N+1,H=v+1,U=0,le=0,ie=new Z;for(let ce=0;ce<H;ce++){let _e=ce*E-O;for(let oe=0;oe<V;oe++){let ue=oe*q-G;ie[M]=ue*y,ie[p]=_e*A,ie[m]=W,c.push(ie.x,ie.y,ie.z),ie[M]=0,ie[p]=0,ie[m]=R>0?1:-1,h.push(ie.x,ie.y,ie.z),f.push(oe/N),f.push(1-ce/v),U+=1}}for(let ce=0;ce<v;ce++)for(let _e=0;_e<N;_e++){let oe=u+_e+V*ce,ue=u+_e+V*(ce+1),et=u+(_e+1)+V*(ce+1),it=u+(_e+1)+V*ce;l.push(oe,ue,it),l.push(ue,et,it),le+=6}a.addGroup(d,le,T),d+=le,u+=U}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Wo=class i extends _n{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,f=e/a,u=t/l,d=[],g=[],M=[],p=[];for(let m=0;m<h;m++){let y=m*u-o;for(let A=0;A<c;A++){let w=A*f-r;g.push(w,-y,0),M.push(0,0,1),p.push(A/a),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let y=0;y<a;y++){let A=y+c*m,w=y+c*(m+1),D=y+1+c*(m+1),R=y+1+c*m;d.push(A,w,R),d.push(w,D,R)}this.setIndex(d),this.setAttribute("position",new ri(g,3)),this.setAttribute("normal",new ri(M,3)),this.setAttribute("uv",new ri(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};function Qs(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(qe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone():Array.isArray(s)?e[t][n]=s.slice():e[t][n]=s}}return e}function Sn(i){let e={};for(let t=0;t<i.length;t++){let n=Qs(i[t]);for(let s in n)e[s]=n[s]}return e}function O0(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function pu(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:ut.workingColorSpace}var Qd={clone:Qs,merge:Sn},B0=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,k0=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Yn=class extends Ss{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=B0,this.fragmentShader=k0,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Qs(e.uniforms),this.uniformsGroups=O0(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}},Xr=class extends Yn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var vl=class extends Ss{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=kd,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},yl=class extends Ss{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ka(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}var Ts=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},Ml=class extends Ts{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:zh,endingEnd:zh}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Vh:r=e,a=2*t-n;break;case Gh:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Vh:o=e,l=2*n-t;break;case Gh:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,f=this._offsetNext,u=this._weightPrev,d=this._weightNext,g=(n-t)/(s-t),M=g*g,p=M*g,m=-u*p+2*u*M-u*g,y=(1+u)*p+(-1.5-2*u)*M+(-.5+u)*g+1,A=(-1-d)*p+(1.5+d)*M+.5*g,w=d*p-d*M;for(let D=0;D!==a;++D)r[D]=m*o[h+D]+y*o[c+D]+A*o[l+D]+w*o[f+D];return r}},bl=class extends Ts{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),f=1-h;for(let u=0;u!==a;++u)r[u]=o[c+u]*f+o[l+u]*h;return r}},Sl=class extends Ts{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},wl=class extends Ts{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.settings||this.DefaultSettings_,f=h.inTangents,u=h.outTangents;if(!f||!u){let M=(n-t)/(s-t),p=1-M;for(let m=0;m!==a;++m)r[m]=o[c+m]*p+o[l+m]*M;return r}let d=a*2,g=e-1;for(let M=0;M!==a;++M){let p=o[c+M],m=o[l+M],y=g*d+M*2,A=u[y],w=u[y+1],D=e*d+M*2,R=f[D],N=f[D+1],v=(n-t)/(s-t),T,q,E,G,O;for(let W=0;W<8;W++){T=v*v,q=T*v,E=1-v,G=E*E,O=G*E;let H=O*t+3*G*v*A+3*E*T*R+q*s-n;if(Math.abs(H)<1e-10)break;let U=3*G*(A-t)+6*E*v*(R-A)+3*T*(s-R);if(Math.abs(U)<1e-10)break;v=v-H/U,v=Math.max(0,Math.min(1,v))}r[M]=O*p+3*G*v*w+3*E*T*N+q*m}return r}},$n=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ka(t,this.TimeBufferType),this.values=Ka(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Ka(e.times,Array),values:Ka(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s)}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Sl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new bl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Ml(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new wl(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.settings=this.settings),t}setInterpolation(e){let t;switch(e){case Co:t=this.InterpolantFactoryMethodDiscrete;break;case fl:t=this.InterpolantFactoryMethodLinear;break;case el:t=this.InterpolantFactoryMethodSmooth;break;case kh:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return qe("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Co;case this.InterpolantFactoryMethodLinear:return fl;case this.InterpolantFactoryMethodSmooth:return el;case this.InterpolantFactoryMethodBezier:return kh}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Xe("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Xe("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Xe("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Xe("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&_0(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Xe("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===el,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let f=a*n,u=f-n,d=f+n;for(let g=0;g!==n;++g){let M=t[f+g];if(M!==t[u+g]||M!==t[d+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*n,u=o*n;for(let d=0;d!==n;++d)t[u+d]=t[f+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,s}};$n.prototype.ValueTypeName="";$n.prototype.TimeBufferType=Float32Array;$n.prototype.ValueBufferType=Float32Array;$n.prototype.DefaultInterpolation=fl;var Es=class extends $n{constructor(e,t,n){super(e,t,n)}};Es.prototype.ValueTypeName="bool";Es.prototype.ValueBufferType=Array;Es.prototype.DefaultInterpolation=Co;Es.prototype.InterpolantFactoryMethodLinear=void 0;Es.prototype.InterpolantFactoryMethodSmooth=void 0;var Al=class extends $n{constructor(e,t,n,s){super(e,t,n,s)}};Al.prototype.ValueTypeName="color";var Tl=class extends $n{constructor(e,t,n,s){super(e,t,n,s)}};Tl.prototype.ValueTypeName="number";var El=class extends Ts{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)Ui.slerpFlat(r,0,o,c-a,o,c,l);return r}},Xo=class extends $n{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new El(this.times,this.values,this.getValueSize(),e)}};Xo.prototype.ValueTypeName="quaternion";Xo.prototype.InterpolantFactoryMethodSmooth=void 0;var Cs=class extends $n{constructor(e,t,n){super(e,t,n)}};Cs.prototype.ValueTypeName="string";Cs.prototype.ValueBufferType=Array;Cs.prototype.DefaultInterpolation=Co;Cs.prototype.InterpolantFactoryMethodLinear=void 0;Cs.prototype.InterpolantFactoryMethodSmooth=void 0;var Cl=class extends $n{constructor(e,t,n,s){super(e,t,n,s)}};Cl.prototype.ValueTypeName="vector";var Rl=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,f){return c.push(h,f),this},this.removeHandler=function(h){let f=c.indexOf(h);return f!==-1&&c.splice(f,2),this},this.getHandler=function(h){for(let f=0,u=c.length;f<u;f+=2){let d=c[f],g=c[f+1];if(d.global&&(d.lastIndex=0),d.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},ep=new Rl,Il=class{constructor(e){this.manager=e!==void 0?e:ep,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}abort(){return this}};Il.DEFAULT_MATERIAL_NAME="__DEFAULT";var ja=new Z,Qa=new Ui,Li=new Z,qo=class extends qn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new $t,this.projectionMatrix=new $t,this.projectionMatrixInverse=new $t,this.coordinateSystem=pi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(ja,Qa,Li),Li.x===1&&Li.y===1&&Li.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ja,Qa,Li.set(1,1,1)).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorld.decompose(ja,Qa,Li),Li.x===1&&Li.y===1&&Li.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ja,Qa,Li.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},vs=new Z,dd=new Mt,pd=new Mt,Un=class extends qo{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=dl*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(gh*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return dl*2*Math.atan(Math.tan(gh*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){vs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(vs.x,vs.y).multiplyScalar(-e/vs.z),vs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(vs.x,vs.y).multiplyScalar(-e/vs.z)}getViewSize(e,t){return this.getViewBounds(e,dd,pd),t.subVectors(pd,dd)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(gh*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Js=class extends qo{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var qr=class extends _n{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Or=-90,Br=1,Pl=class extends qn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Un(Or,Br,e,t);s.layers=this.layers,this.add(s);let r=new Un(Or,Br,e,t);r.layers=this.layers,this.add(r);let o=new Un(Or,Br,e,t);o.layers=this.layers,this.add(o);let a=new Un(Or,Br,e,t);a.layers=this.layers,this.add(a);let l=new Un(Or,Br,e,t);l.layers=this.layers,this.add(l);let c=new Un(Or,Br,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===pi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Io)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,f=e.getRenderTarget(),u=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let M=n.texture.generateMipmaps;n.texture.generateMipmaps=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.generateMipmaps=M,e.setRenderTarget(n,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(f,u,d),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},Ll=class extends Un{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}};var mu="\\[\\]\\.:\\/",z0=new RegExp("["+mu+"]","g"),gu="[^"+mu+"]",V0="[^"+mu.replace("\\.","")+"]",G0=/((?:WC+[\/:])*)/.source.replace("WC",gu),H0=/(WCOD+)?/.source.replace("WCOD",V0),W0=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",gu),X0=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",gu),q0=new RegExp("^"+G0+H0+W0+X0+"$"),Y0=["material","materials","bones","map"],qh=class{constructor(e,t,n){let s=n||Ot.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Ot=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(z0,"")}static parseTrackName(e){let t=q0.exec(e);if(t===null)throw new Error("PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Y0.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){qe("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){Xe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Xe("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Xe("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Xe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Xe("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){Xe("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){Xe("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Xe("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Xe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Xe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ot.Composite=qh;Ot.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ot.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ot.prototype.GetterByBindingType=[Ot.prototype._getValue_direct,Ot.prototype._getValue_array,Ot.prototype._getValue_arrayElement,Ot.prototype._getValue_toArray];Ot.prototype.SetterByBindingTypeAndVersioning=[[Ot.prototype._setValue_direct,Ot.prototype._setValue_direct_setNeedsUpdate,Ot.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ot.prototype._setValue_array,Ot.prototype._setValue_array_setNeedsUpdate,Ot.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ot.prototype._setValue_arrayElement,Ot.prototype._setValue_arrayElement_setNeedsUpdate,Ot.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ot.prototype._setValue_fromArray,Ot.prototype._setValue_fromArray_setNeedsUpdate,Ot.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Hw=new Float32Array(1);function _u(i,e,t,n){let s=$0(n);switch(t){case hu:return i*e;case fu:return i*e/s.components*s.byteLength;case kl:return i*e/s.components*s.byteLength;case js:return i*e*2/s.components*s.byteLength;case zl:return i*e*2/s.components*s.byteLength;case uu:return i*e*3/s.components*s.byteLength;case Pn:return i*e*4/s.components*s.byteLength;case Jr:return i*e*4/s.components*s.byteLength;case Jo:case Ko:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case jo:case Qo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Gl:case Wl:return Math.max(i,16)*Math.max(e,8)/4;case Vl:case Hl:return Math.max(i,8)*Math.max(e,8)/2;case Xl:case ql:case $l:case Zl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Yl:case Jl:case Kl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case jl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ql:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case ec:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case tc:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case nc:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case ic:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case sc:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case rc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case oc:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case ac:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case lc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case cc:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case hc:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case uc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case fc:case dc:case pc:return Math.ceil(i/4)*Math.ceil(e/4)*16;case mc:case gc:return Math.ceil(i/4)*Math.ceil(e/4)*8;case _c:case xc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function $0(i){switch(i){case bn:case ou:return{byteLength:1,components:1};case $r:case au:case zi:return{byteLength:2,components:1};case Ol:case Bl:return{byteLength:2,components:4};case gi:case Ul:case Zn:return{byteLength:4,components:1};case lu:case cu:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"183"}}));typeof window<"u"&&(window.__THREE__?qe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="183");function Sp(){let i=null,e=!1,t=null,n=null;function s(r,o){t(r,o),n=i.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function J0(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,f=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function n(a,l,c){let h=l.array,f=l.updateRanges;if(i.bindBuffer(c,a),f.length===0)i.bufferSubData(c,0,h);else{f.sort((d,g)=>d.start-g.start);let u=0;for(let d=1;d<f.length;d++){let g=f[u],M=f[d];M.start<=g.start+g.count+1?g.count=Math.max(g.count,M.start+M.count-g.start):(++u,f[u]=M)}f.length=u+1;for(let d=0,g=f.length;d<g;d++){let M=f[d];i.bufferSubData(c,M.start*h.BYTES_PER_ELEMENT,h,M.start,M.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var K0=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,j0=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Q0=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,e_=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,t_=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,n_=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,i_=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,s_=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,r_=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,o_=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,a_=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,l_=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,c_=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,h_=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,u_=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,f_=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,d_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,p_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,m_=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,g_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,__=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,x_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,v_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,y_=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,M_=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,b_=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,S_=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,w_=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,A_=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,T_=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,E_="gl_FragColor = linearToOutputTexel( gl_FragColor );",C_=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,R_=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,I_=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
#endif`,P_=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,L_=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,D_=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,N_=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,F_=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,U_=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,O_=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,B_=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,k_=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,z_=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,V_=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,G_=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,H_=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,W_=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,X_=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,q_=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Y_=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,$_=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Z_=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
		vec3 iridescenceFresnelDielectric;
		vec3 iridescenceFresnelMetallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return v;
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
vec3 BRDF_GGX_Multiscatter( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 singleScatter = BRDF_GGX( lightDir, viewDir, normal, material );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 dfgV = texture2D( dfgLUT, vec2( material.roughness, dotNV ) ).rg;
	vec2 dfgL = texture2D( dfgLUT, vec2( material.roughness, dotNL ) ).rg;
	vec3 FssEss_V = material.specularColorBlended * dfgV.x + material.specularF90 * dfgV.y;
	vec3 FssEss_L = material.specularColorBlended * dfgL.x + material.specularF90 * dfgL.y;
	float Ess_V = dfgV.x + dfgV.y;
	float Ess_L = dfgL.x + dfgL.y;
	float Ems_V = 1.0 - Ess_V;
	float Ems_L = 1.0 - Ess_L;
	vec3 Favg = material.specularColorBlended + ( 1.0 - material.specularColorBlended ) * 0.047619;
	vec3 Fms = FssEss_V * FssEss_L * Favg / ( 1.0 - Ems_V * Ems_L * Favg + EPSILON );
	float compensationFactor = Ems_V * Ems_L;
	vec3 multiScatter = Fms * compensationFactor;
	return singleScatter + multiScatter;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX_Multiscatter( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseContribution );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution );
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnelDielectric, material.roughness, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceFresnelMetallic, material.roughness, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( geometryNormal, geometryViewDir, material.diffuseColor, material.specularF90, material.roughness, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,J_=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( material.iridescenceFresnelDielectric, material.iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,K_=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_CUBE_UV )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,j_=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Q_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,ex=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,tx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,nx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,ix=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,sx=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,rx=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,ox=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ax=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,lx=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,cx=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,hx=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,ux=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,fx=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,dx=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,px=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,mx=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,gx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,_x=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,xx=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,vx=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,yx=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Mx=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,bx=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Sx=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,wx=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Ax=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Tx=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Ex=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Cx=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Rx=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Ix=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Px=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Lx=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			shadowCoord.z += shadowBias;
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				float radius = shadowRadius * texelSize.x;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float dp = ( shadowCameraNear * ( shadowCameraFar - viewSpaceZ ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
				dp -= shadowBias;
			#else
				float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
				dp += shadowBias;
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			vec2 sample0 = vogelDiskSample( 0, 5, phi );
			vec2 sample1 = vogelDiskSample( 1, 5, phi );
			vec2 sample2 = vogelDiskSample( 2, 5, phi );
			vec2 sample3 = vogelDiskSample( 3, 5, phi );
			vec2 sample4 = vogelDiskSample( 4, 5, phi );
			shadow = (
				texture( shadowMap, vec4( bd3D + ( tangent * sample0.x + bitangent * sample0.y ) * texelSize, dp ) ) +
				texture( shadowMap, vec4( bd3D + ( tangent * sample1.x + bitangent * sample1.y ) * texelSize, dp ) ) +
				texture( shadowMap, vec4( bd3D + ( tangent * sample2.x + bitangent * sample2.y ) * texelSize, dp ) ) +
				texture( shadowMap, vec4( bd3D + ( tangent * sample3.x + bitangent * sample3.y ) * texelSize, dp ) ) +
				texture( shadowMap, vec4( bd3D + ( tangent * sample4.x + bitangent * sample4.y ) * texelSize, dp ) )
			) * 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Dx=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Nx=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Fx=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Ux=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Ox=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Bx=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,kx=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,zx=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Vx=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Gx=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Hx=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,Wx=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Xx=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,qx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Yx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,$x=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Zx=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Jx=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Kx=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,jx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Qx=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ev=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,tv=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,nv=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,iv=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,sv=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,rv=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,ov=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,av=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,lv=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,cv=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,hv=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,uv=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,fv=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,dv=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,pv=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,mv=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,gv=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,_v=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,xv=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,vv=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,yv=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Mv=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,bv=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Sv=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,wv=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Av=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Tv=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Ev=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Cv=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Rv=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,st={alphahash_fragment:K0,alphahash_pars_fragment:j0,alphamap_fragment:Q0,alphamap_pars_fragment:e_,alphatest_fragment:t_,alphatest_pars_fragment:n_,aomap_fragment:i_,aomap_pars_fragment:s_,batching_pars_vertex:r_,batching_vertex:o_,begin_vertex:a_,beginnormal_vertex:l_,bsdfs:c_,iridescence_fragment:h_,bumpmap_pars_fragment:u_,clipping_planes_fragment:f_,clipping_planes_pars_fragment:d_,clipping_planes_pars_vertex:p_,clipping_planes_vertex:m_,color_fragment:g_,color_pars_fragment:__,color_pars_vertex:x_,color_vertex:v_,common:y_,cube_uv_reflection_fragment:M_,defaultnormal_vertex:b_,displacementmap_pars_vertex:S_,displacementmap_vertex:w_,emissivemap_fragment:A_,emissivemap_pars_fragment:T_,colorspace_fragment:E_,colorspace_pars_fragment:C_,envmap_fragment:R_,envmap_common_pars_fragment:I_,envmap_pars_fragment:P_,envmap_pars_vertex:L_,envmap_physical_pars_fragment:H_,envmap_vertex:D_,fog_vertex:N_,fog_pars_vertex:F_,fog_fragment:U_,fog_pars_fragment:O_,gradientmap_pars_fragment:B_,lightmap_pars_fragment:k_,lights_lambert_fragment:z_,lights_lambert_pars_fragment:V_,lights_pars_begin:G_,lights_toon_fragment:W_,lights_toon_pars_fragment:X_,lights_phong_fragment:q_,lights_phong_pars_fragment:Y_,lights_physical_fragment:$_,lights_physical_pars_fragment:Z_,lights_fragment_begin:J_,lights_fragment_maps:K_,lights_fragment_end:j_,logdepthbuf_fragment:Q_,logdepthbuf_pars_fragment:ex,logdepthbuf_pars_vertex:tx,logdepthbuf_vertex:nx,map_fragment:ix,map_pars_fragment:sx,map_particle_fragment:rx,map_particle_pars_fragment:ox,metalnessmap_fragment:ax,metalnessmap_pars_fragment:lx,morphinstance_vertex:cx,morphcolor_vertex:hx,morphnormal_vertex:ux,morphtarget_pars_vertex:fx,morphtarget_vertex:dx,normal_fragment_begin:px,normal_fragment_maps:mx,normal_pars_fragment:gx,normal_pars_vertex:_x,normal_vertex:xx,normalmap_pars_fragment:vx,clearcoat_normal_fragment_begin:yx,clearcoat_normal_fragment_maps:Mx,clearcoat_pars_fragment:bx,iridescence_pars_fragment:Sx,opaque_fragment:wx,packing:Ax,premultiplied_alpha_fragment:Tx,project_vertex:Ex,dithering_fragment:Cx,dithering_pars_fragment:Rx,roughnessmap_fragment:Ix,roughnessmap_pars_fragment:Px,shadowmap_pars_fragment:Lx,shadowmap_pars_vertex:Dx,shadowmap_vertex:Nx,shadowmask_pars_fragment:Fx,skinbase_vertex:Ux,skinning_pars_vertex:Ox,skinning_vertex:Bx,skinnormal_vertex:kx,specularmap_fragment:zx,specularmap_pars_fragment:Vx,tonemapping_fragment:Gx,tonemapping_pars_fragment:Hx,transmission_fragment:Wx,transmission_pars_fragment:Xx,uv_pars_fragment:qx,uv_pars_vertex:Yx,uv_vertex:$x,worldpos_vertex:Zx,background_vert:Jx,background_frag:Kx,backgroundCube_vert:jx,backgroundCube_frag:Qx,cube_vert:ev,cube_frag:tv,depth_vert:nv,depth_frag:iv,distance_vert:sv,distance_frag:rv,equirect_vert:ov,equirect_frag:av,linedashed_vert:lv,linedashed_frag:cv,meshbasic_vert:hv,meshbasic_frag:uv,meshlambert_vert:fv,meshlambert_frag:dv,meshmatcap_vert:pv,meshmatcap_frag:mv,meshnormal_vert:gv,meshnormal_frag:_v,meshphong_vert:xv,meshphong_frag:vv,meshphysical_vert:yv,meshphysical_frag:Mv,meshtoon_vert:bv,meshtoon_frag:Sv,points_vert:wv,points_frag:Av,shadow_vert:Tv,shadow_frag:Ev,sprite_vert:Cv,sprite_frag:Rv},be={common:{diffuse:{value:new ft(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new nt}},envmap:{envMap:{value:null},envMapRotation:{value:new nt},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new nt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new nt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new nt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new nt},normalScale:{value:new Mt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new nt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new nt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new nt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new nt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ft(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new ft(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0},uvTransform:{value:new nt}},sprite:{diffuse:{value:new ft(16777215)},opacity:{value:1},center:{value:new Mt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}}},Gi={basic:{uniforms:Sn([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.fog]),vertexShader:st.meshbasic_vert,fragmentShader:st.meshbasic_frag},lambert:{uniforms:Sn([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.fog,be.lights,{emissive:{value:new ft(0)},envMapIntensity:{value:1}}]),vertexShader:st.meshlambert_vert,fragmentShader:st.meshlambert_frag},phong:{uniforms:Sn([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.fog,be.lights,{emissive:{value:new ft(0)},specular:{value:new ft(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:st.meshphong_vert,fragmentShader:st.meshphong_frag},standard:{uniforms:Sn([be.common,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.roughnessmap,be.metalnessmap,be.fog,be.lights,{emissive:{value:new ft(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:st.meshphysical_vert,fragmentShader:st.meshphysical_frag},toon:{uniforms:Sn([be.common,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.gradientmap,be.fog,be.lights,{emissive:{value:new ft(0)}}]),vertexShader:st.meshtoon_vert,fragmentShader:st.meshtoon_frag},matcap:{uniforms:Sn([be.common,be.bumpmap,be.normalmap,be.displacementmap,be.fog,{matcap:{value:null}}]),vertexShader:st.meshmatcap_vert,fragmentShader:st.meshmatcap_frag},points:{uniforms:Sn([be.points,be.fog]),vertexShader:st.points_vert,fragmentShader:st.points_frag},dashed:{uniforms:Sn([be.common,be.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:st.linedashed_vert,fragmentShader:st.linedashed_frag},depth:{uniforms:Sn([be.common,be.displacementmap]),vertexShader:st.depth_vert,fragmentShader:st.depth_frag},normal:{uniforms:Sn([be.common,be.bumpmap,be.normalmap,be.displacementmap,{opacity:{value:1}}]),vertexShader:st.meshnormal_vert,fragmentShader:st.meshnormal_frag},sprite:{uniforms:Sn([be.sprite,be.fog]),vertexShader:st.sprite_vert,fragmentShader:st.sprite_frag},background:{uniforms:{uvTransform:{value:new nt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:st.background_vert,fragmentShader:st.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new nt}},vertexShader:st.backgroundCube_vert,fragmentShader:st.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:st.cube_vert,fragmentShader:st.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:st.equirect_vert,fragmentShader:st.equirect_frag},distance:{uniforms:Sn([be.common,be.displacementmap,{referencePosition:{value:new Z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:st.distance_vert,fragmentShader:st.distance_frag},shadow:{uniforms:Sn([be.lights,be.fog,{color:{value:new ft(0)},opacity:{value:1}}]),vertexShader:st.shadow_vert,fragmentShader:st.shadow_frag}};Gi.physical={uniforms:Sn([Gi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new nt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new nt},clearcoatNormalScale:{value:new Mt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new nt},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new nt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new nt},sheen:{value:0},sheenColor:{value:new ft(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new nt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new nt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new nt},transmissionSamplerSize:{value:new Mt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new nt},attenuationDistance:{value:0},attenuationColor:{value:new ft(0)},specularColor:{value:new ft(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new nt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new nt},anisotropyVector:{value:new Mt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new nt}}]),vertexShader:st.meshphysical_vert,fragmentShader:st.meshphysical_frag};var Mc={r:0,b:0,g:0},er=new Oi,Iv=new $t;function Pv(i,e,t,n,s,r){let o=new ft(0),a=s===!0?0:1,l,c,h=null,f=0,u=null;function d(y){let A=y.isScene===!0?y.background:null;if(A&&A.isTexture){let w=y.backgroundBlurriness>0;A=e.get(A,w)}return A}function g(y){let A=!1,w=d(y);w===null?p(o,a):w&&w.isColor&&(p(w,1),A=!0);let D=i.xr.getEnvironmentBlendMode();D==="additive"?t.buffers.color.setClear(0,0,0,1,r):D==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function M(y,A){let w=d(A);w&&(w.isCubeTexture||w.mapping===$o)?(c===void 0&&(c=new Mn(new Wr(1,1,1),new Yn({name:"BackgroundCubeMaterial",uniforms:Qs(Gi.backgroundCube.uniforms),vertexShader:Gi.backgroundCube.vertexShader,fragmentShader:Gi.backgroundCube.fragmentShader,side:In,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(D,R,N){this.matrixWorld.copyPosition(N.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),er.copy(A.backgroundRotation),er.x*=-1,er.y*=-1,er.z*=-1,w.isCubeTexture&&w.isRenderTargetTexture===!1&&(er.y*=-1,er.z*=-1),c.material.uniforms.envMap.value=w,c.material.uniforms.flipEnvMap.value=w.isCubeTexture&&w.isRenderTargetTexture===!1?-1:1,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Iv.makeRotationFromEuler(er)),c.material.toneMapped=ut.getTransfer(w.colorSpace)!==St,(h!==w||f!==w.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=w,f=w.version,u=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):w&&w.isTexture&&(l===void 0&&(l=new Mn(new Wo(2,2),new Yn({name:"BackgroundMaterial",uniforms:Qs(Gi.background.uniforms),vertexShader:Gi.background.vertexShader,fragmentShader:Gi.background.fragmentShader,side:ji,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=w,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=ut.getTransfer(w.colorSpace)!==St,w.matrixAutoUpdate===!0&&w.updateMatrix(),l.material.uniforms.uvTransform.value.copy(w.matrix),(h!==w||f!==w.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=w,f=w.version,u=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function p(y,A){y.getRGB(Mc,pu(i)),t.buffers.color.setClear(Mc.r,Mc.g,Mc.b,A,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,A=1){o.set(y),a=A,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,p(o,a)},render:g,addToRenderList:M,dispose:m}}function Lv(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null),r=s,o=!1;function a(E,G,O,W,V){let H=!1,U=f(E,W,O,G);r!==U&&(r=U,c(r.object)),H=d(E,W,O,V),H&&g(E,W,O,V),V!==null&&e.update(V,i.ELEMENT_ARRAY_BUFFER),(H||o)&&(o=!1,w(E,G,O,W),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return i.createVertexArray()}function c(E){return i.bindVertexArray(E)}function h(E){return i.deleteVertexArray(E)}function f(E,G,O,W){let V=W.wireframe===!0,H=n[G.id];H===void 0&&(H={},n[G.id]=H);let U=E.isInstancedMesh===!0?E.id:0,le=H[U];le===void 0&&(le={},H[U]=le);let ie=le[O.id];ie===void 0&&(ie={},le[O.id]=ie);let ce=ie[V];return ce===void 0&&(ce=u(l()),ie[V]=ce),ce}function u(E){let G=[],O=[],W=[];for(let V=0;V<t;V++)G[V]=0,O[V]=0,W[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:O,attributeDivisors:W,object:E,attributes:{},index:null}}function d(E,G,O,W){let V=r.attributes,H=G.attributes,U=0,le=O.getAttributes();for(let ie in le)if(le[ie].location>=0){let _e=V[ie],oe=H[ie];if(oe===void 0&&(ie==="instanceMatrix"&&E.instanceMatrix&&(oe=E.instanceMatrix),ie==="instanceColor"&&E.instanceColor&&(oe=E.instanceColor)),_e===void 0||_e.attribute!==oe||oe&&_e.data!==oe.data)return!0;U++}return r.attributesNum!==U||r.index!==W}function g(E,G,O,W){let V={},H=G.attributes,U=0,le=O.getAttributes();for(let ie in le)if(le[ie].location>=0){let _e=H[ie];_e===void 0&&(ie==="instanceMatrix"&&E.instanceMatrix&&(_e=E.instanceMatrix),ie==="instanceColor"&&E.instanceColor&&(_e=E.instanceColor));let oe={};oe.attribute=_e,_e&&_e.data&&(oe.data=_e.data),V[ie]=oe,U++}r.attributes=V,r.attributesNum=U,r.index=W}function M(){let E=r.newAttributes;for(let G=0,O=E.length;G<O;G++)E[G]=0}function p(E){m(E,0)}function m(E,G){let O=r.newAttributes,W=r.enabledAttributes,V=r.attributeDivisors;O[E]=1,W[E]===0&&(i.enableVertexAttribArray(E),W[E]=1),V[E]!==G&&(i.vertexAttribDivisor(E,G),V[E]=G)}function y(){let E=r.newAttributes,G=r.enabledAttributes;for(let O=0,W=G.length;O<W;O++)G[O]!==E[O]&&(i.disableVertexAttribArray(O),G[O]=0)}function A(E,G,O,W,V,H,U){U===!0?i.vertexAttribIPointer(E,G,O,V,H):i.vertexAttribPointer(E,G,O,W,V,H)}function w(E,G,O,W){M();let V=W.attributes,H=O.getAttributes(),U=G.defaultAttributeValues;for(let le in H){let ie=H[le];if(ie.location>=0){let ce=V[le];if(ce===void 0&&(le==="instanceMatrix"&&E.instanceMatrix&&(ce=E.instanceMatrix),le==="instanceColor"&&E.instanceColor&&(ce=E.instanceColor)),ce!==void 0){let _e=ce.normalized,oe=ce.itemSize,ue=e.get(ce);if(ue===void 0)continue;let et=ue.buffer,it=ue.type,Q=ue.bytesPerElement,re=it===i.INT||it===i.UNSIGNED_INT||ce.gpuType===Ul;if(ce.isInterleavedBufferAttribute){let me=ce.data,He=me.stride,Se=ce.offset;if(me.isInstancedInterleavedBuffer){for(let Ge=0;Ge<ie.locationSize;Ge++)m(ie.location+Ge,me.meshPerAttribute);E.isInstancedMesh!==!0&&W._maxInstanceCount===void 0&&(W._maxInstanceCount=me.meshPerAttribute*me.count)}else for(let Ge=0;Ge<ie.locationSize;Ge++)p(ie.location+Ge);i.bindBuffer(i.ARRAY_BUFFER,et);for(let Ge=0;Ge<ie.locationSize;Ge++)A(ie.location+Ge,oe/ie.locationSize,it,_e,He*Q,(Se+oe/ie.locationSize*Ge)*Q,re)}else{if(ce.isInstancedBufferAttribute){for(let me=0;me<ie.locationSize;me++)m(ie.location+me,ce.meshPerAttribute);E.isInstancedMesh!==!0&&W._maxInstanceCount===void 0&&(W._maxInstanceCount=ce.meshPerAttribute*ce.count)}else for(let me=0;me<ie.locationSize;me++)p(ie.location+me);i.bindBuffer(i.ARRAY_BUFFER,et);for(let me=0;me<ie.locationSize;me++)A(ie.location+me,oe/ie.locationSize,it,_e,oe*Q,oe/ie.locationSize*me*Q,re)}}else if(U!==void 0){let _e=U[le];if(_e!==void 0)switch(_e.length){case 2:i.vertexAttrib2fv(ie.location,_e);break;case 3:i.vertexAttrib3fv(ie.location,_e);break;case 4:i.vertexAttrib4fv(ie.location,_e);break;default:i.vertexAttrib1fv(ie.location,_e)}}}}y()}function D(){T();for(let E in n){let G=n[E];for(let O in G){let W=G[O];for(let V in W){let H=W[V];for(let U in H)h(H[U].object),delete H[U];delete W[V]}}delete n[E]}}function R(E){if(n[E.id]===void 0)return;let G=n[E.id];for(let O in G){let W=G[O];for(let V in W){let H=W[V];for(let U in H)h(H[U].object),delete H[U];delete W[V]}}delete n[E.id]}function N(E){for(let G in n){let O=n[G];for(let W in O){let V=O[W];if(V[E.id]===void 0)continue;let H=V[E.id];for(let U in H)h(H[U].object),delete H[U];delete V[E.id]}}}function v(E){for(let G in n){let O=n[G],W=E.isInstancedMesh===!0?E.id:0,V=O[W];if(V!==void 0){for(let H in V){let U=V[H];for(let le in U)h(U[le].object),delete U[le];delete V[H]}delete O[W],Object.keys(O).length===0&&delete n[G]}}}function T(){q(),o=!0,r!==s&&(r=s,c(r.object))}function q(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:T,resetDefaultState:q,dispose:D,releaseStatesOfGeometry:R,releaseStatesOfObject:v,releaseStatesOfProgram:N,initAttributes:M,enableAttribute:p,disableUnusedAttributes:y}}function Dv(i,e,t){let n;function s(c){n=c}function r(c,h){i.drawArrays(n,c,h),t.update(h,n,1)}function o(c,h,f){f!==0&&(i.drawArraysInstanced(n,c,h,f),t.update(h,n,f))}function a(c,h,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,h,0,f);let d=0;for(let g=0;g<f;g++)d+=h[g];t.update(d,n,1)}function l(c,h,f,u){if(f===0)return;let d=e.get("WEBGL_multi_draw");if(d===null)for(let g=0;g<c.length;g++)o(c[g],h[g],u[g]);else{d.multiDrawArraysInstancedWEBGL(n,c,0,h,0,u,0,f);let g=0;for(let M=0;M<f;M++)g+=h[M]*u[M];t.update(g,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function Nv(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let N=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(N.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(N){return!(N!==Pn&&n.convert(N)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(N){let v=N===zi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(N!==bn&&n.convert(N)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&N!==Zn&&!v)}function l(N){if(N==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";N="mediump"}return N==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(qe("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let f=t.logarithmicDepthBuffer===!0,u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),M=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),w=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),D=i.getParameter(i.MAX_SAMPLES),R=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:d,maxVertexTextures:g,maxTextureSize:M,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:y,maxVaryings:A,maxFragmentUniforms:w,maxSamples:D,samples:R}}function Fv(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Di,a=new nt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,u){let d=f.length!==0||u||n!==0||s;return s=u,n=f.length,d},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,u){t=h(f,u,0)},this.setState=function(f,u,d){let g=f.clippingPlanes,M=f.clipIntersection,p=f.clipShadows,m=i.get(f);if(!s||g===null||g.length===0||r&&!p)r?h(null):c();else{let y=r?0:n,A=y*4,w=m.clippingState||null;l.value=w,w=h(g,u,A,d);for(let D=0;D!==A;++D)w[D]=t[D];m.clippingState=w,this.numIntersection=M?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(f,u,d,g){let M=f!==null?f.length:0,p=null;if(M!==0){if(p=l.value,g!==!0||p===null){let m=d+M*4,y=u.matrixWorldInverse;a.getNormalMatrix(y),(p===null||p.length<m)&&(p=new Float32Array(m));for(let A=0,w=d;A!==M;++A,w+=4)o.copy(f[A]).applyMatrix4(y,a),o.normal.toArray(p,w),p[w+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=M,e.numIntersection=0,p}}var Ls=4,tp=[.125,.215,.35,.446,.526,.582],nr=20,Uv=256,na=new Js,np=new ft,xu=null,vu=0,yu=0,Mu=!1,Ov=new Z,Sc=class{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._sizeLods=[],this._sigmas=[],this._lodMeshes=[],this._backgroundBox=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=Ov}=r;xu=this._renderer.getRenderTarget(),vu=this._renderer.getActiveCubeFace(),yu=this._renderer.getActiveMipmapLevel(),Mu=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(e,n,s,l,a),t>0&&this._blur(l,0,0,t),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=rp(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=sp(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._backgroundBox!==null&&(this._backgroundBox.geometry.dispose(),this._backgroundBox.material.dispose())}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodMeshes.length;e++)this._lodMeshes[e].geometry.dispose()}_cleanup(e){this._renderer.setRenderTarget(xu,vu,yu),this._renderer.xr.enabled=Mu,e.scissorTest=!1,Kr(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===Rs||e.mapping===Ks?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),xu=this._renderer.getRenderTarget(),vu=this._renderer.getActiveCubeFace(),yu=this._renderer.getActiveMipmapLevel(),Mu=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=t||this._allocateTargets();return this._textureToCubeUV(e,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,n={magFilter:gn,minFilter:gn,generateMipmaps:!1,type:zi,format:Pn,colorSpace:Zs,depthBuffer:!1},s=ip(e,t,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=ip(e,t,n);let{_lodMax:r}=this;({lodMeshes:this._lodMeshes,sizeLods:this._sizeLods,sigmas:this._sigmas}=Bv(r)),this._blurMaterial=zv(r,e,t),this._ggxMaterial=kv(r,e,t)}return s}_compileMaterial(e){let t=new Mn(new _n,e);this._renderer.compile(t,na)}_sceneToCubeUV(e,t,n,s,r){let l=new Un(90,1,t,n),c=[1,-1,1,1,1,1],h=[1,1,1,-1,-1,-1],f=this._renderer,u=f.autoClear,d=f.toneMapping;f.getClearColor(np),f.toneMapping=mi,f.autoClear=!1,f.state.buffers.depth.getReversed()&&(f.setRenderTarget(s),f.clearDepth(),f.setRenderTarget(null)),this._backgroundBox===null&&(this._backgroundBox=new Mn(new Wr,new Bo({name:"PMREM.Background",side:In,depthWrite:!1,depthTest:!1})));let M=this._backgroundBox,p=M.material,m=!1,y=e.background;y?y.isColor&&(p.color.copy(y),e.background=null,m=!0):(p.color.copy(np),m=!0);for(let A=0;A<6;A++){let w=A%3;w===0?(l.up.set(0,c[A],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+h[A],r.y,r.z)):w===1?(l.up.set(0,0,c[A]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+h[A],r.z)):(l.up.set(0,c[A],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+h[A]));let D=this._cubeSize;Kr(s,w*D,A>2?D:0,D,D),f.setRenderTarget(s),m&&f.render(M,l),f.render(e,l)}f.toneMapping=d,f.autoClear=u,e.background=y}_textureToCubeUV(e,t){let n=this._renderer,s=e.mapping===Rs||e.mapping===Ks;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=rp()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=sp());let r=s?this._cubemapMaterial:this._equirectMaterial,o=this._lodMeshes[0];o.material=r;let a=r.uniforms;a.envMap.value=e;let l=this._cubeSize;Kr(t,0,0,3*l,2*l),n.setRenderTarget(t),n.render(o,na)}_applyPMREM(e){let t=this._renderer,n=t.autoClear;t.autoClear=!1;let s=this._lodMeshes.length;for(let r=1;r<s;r++)this._applyGGXFilter(e,r-1,r);t.autoClear=n}_applyGGXFilter(e,t,n){let s=this._renderer,r=this._pingPongRenderTarget,o=this._ggxMaterial,a=this._lodMeshes[n];a.material=o;let l=o.uniforms,c=n/(this._lodMeshes.length-1),h=t/(this._lodMeshes.length-1),f=Math.sqrt(c*c-h*h),u=0+c*1.25,d=f*u,{_lodMax:g}=this,M=this._sizeLods[n],p=3*M*(n>g-Ls?n-g+Ls:0),m=4*(this._cubeSize-M);l.envMap.value=e.texture,l.roughness.value=d,l.mipInt.value=g-t,Kr(r,p,m,3*M,2*M),s.setRenderTarget(r),s.render(a,na),l.envMap.value=r.texture,l.roughness.value=0,l.mipInt.value=g-n,Kr(e,p,m,3*M,2*M),s.setRenderTarget(e),s.render(a,na)}_blur(e,t,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(e,o,t,n,s,"latitudinal",r),this._halfBlur(o,e,n,n,s,"longitudinal",r)}_halfBlur(e,t,n,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&Xe("blur direction must be either latitudinal or longitudinal!");let h=3,f=this._lodMeshes[s];f.material=c;let u=c.uniforms,d=this._sizeLods[n]-1,g=isFinite(r)?Math.PI/(2*d):2*Math.PI/(2*nr-1),M=r/g,p=isFinite(r)?1+Math.floor(h*M):nr;p>nr&&qe(`sigmaRadians, ${r}, is too large and will clip, as it requested ${p} samples when the maximum is set to ${nr}`);let m=[],y=0;for(let N=0;N<nr;++N){let v=N/M,T=Math.exp(-v*v/2);m.push(T),N===0?y+=T:N<p&&(y+=2*T)}for(let N=0;N<m.length;N++)m[N]=m[N]/y;u.envMap.value=e.texture,u.samples.value=p,u.weights.value=m,u.latitudinal.value=o==="latitudinal",a&&(u.poleAxis.value=a);let{_lodMax:A}=this;u.dTheta.value=g,u.mipInt.value=A-n;let w=this._sizeLods[s],D=3*w*(s>A-Ls?s-A+Ls:0),R=4*(this._cubeSize-w);Kr(t,D,R,3*w,2*w),l.setRenderTarget(t),l.render(f,na)}};function Bv(i){let e=[],t=[],n=[],s=i,r=i-Ls+1+tp.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);e.push(a);let l=1/a;o>i-Ls?l=tp[o-i+Ls-1]:o===0&&(l=0),t.push(l);let c=1/(a-2),h=-c,f=1+c,u=[h,h,f,h,f,f,h,h,f,f,h,f],d=6,g=6,M=3,p=2,m=1,y=new Float32Array(M*g*d),A=new Float32Array(p*g*d),w=new Float32Array(m*g*d);for(let R=0;R<d;R++){let N=R%3*2/3-1,v=R>2?0:-1,T=[N,v,0,N+2/3,v,0,N+2/3,v+1,0,N,v,0,N+2/3,v+1,0,N,v+1,0];y.set(T,M*g*R),A.set(u,p*g*R);let q=[R,R,R,R,R,R];w.set(q,m*g*R)}let D=new _n;D.setAttribute("position",new mn(y,M)),D.setAttribute("uv",new mn(A,p)),D.setAttribute("faceIndex",new mn(w,m)),n.push(new Mn(D,null)),s>Ls&&s--}return{lodMeshes:n,sizeLods:e,sigmas:t}}function ip(i,e,t){let n=new Rn(i,e,t);return n.texture.mapping=$o,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function Kr(i,e,t,n,s){i.viewport.set(e,t,n,s),i.scissor.set(e,t,n,s)}function kv(i,e,t){return new Yn({name:"PMREMGGXConvolution",defines:{GGX_SAMPLES:Uv,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},roughness:{value:0},mipInt:{value:0}},vertexShader:Tc(),fragmentShader:`

			precision highp float;
			precision highp int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform float roughness;
			uniform float mipInt;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			#define PI 3.14159265359

			// Van der Corput radical inverse
			float radicalInverse_VdC(uint bits) {
				bits = (bits << 16u) | (bits >> 16u);
				bits = ((bits & 0x55555555u) << 1u) | ((bits & 0xAAAAAAAAu) >> 1u);
				bits = ((bits & 0x33333333u) << 2u) | ((bits & 0xCCCCCCCCu) >> 2u);
				bits = ((bits & 0x0F0F0F0Fu) << 4u) | ((bits & 0xF0F0F0F0u) >> 4u);
				bits = ((bits & 0x00FF00FFu) << 8u) | ((bits & 0xFF00FF00u) >> 8u);
				return float(bits) * 2.3283064365386963e-10; // / 0x100000000
			}

			// Hammersley sequence
			vec2 hammersley(uint i, uint N) {
				return vec2(float(i) / float(N), radicalInverse_VdC(i));
			}

			// GGX VNDF importance sampling (Eric Heitz 2018)
			// "Sampling the GGX Distribution of Visible Normals"
			// https://jcgt.org/published/0007/04/01/
			vec3 importanceSampleGGX_VNDF(vec2 Xi, vec3 V, float roughness) {
				float alpha = roughness * roughness;

				// Section 4.1: Orthonormal basis
				vec3 T1 = vec3(1.0, 0.0, 0.0);
				vec3 T2 = cross(V, T1);

				// Section 4.2: Parameterization of projected area
				float r = sqrt(Xi.x);
				float phi = 2.0 * PI * Xi.y;
				float t1 = r * cos(phi);
				float t2 = r * sin(phi);
				float s = 0.5 * (1.0 + V.z);
				t2 = (1.0 - s) * sqrt(1.0 - t1 * t1) + s * t2;

				// Section 4.3: Reprojection onto hemisphere
				vec3 Nh = t1 * T1 + t2 * T2 + sqrt(max(0.0, 1.0 - t1 * t1 - t2 * t2)) * V;

				// Section 3.4: Transform back to ellipsoid configuration
				return normalize(vec3(alpha * Nh.x, alpha * Nh.y, max(0.0, Nh.z)));
			}

			void main() {
				vec3 N = normalize(vOutputDirection);
				vec3 V = N; // Assume view direction equals normal for pre-filtering

				vec3 prefilteredColor = vec3(0.0);
				float totalWeight = 0.0;

				// For very low roughness, just sample the environment directly
				if (roughness < 0.001) {
					gl_FragColor = vec4(bilinearCubeUV(envMap, N, mipInt), 1.0);
					return;
				}

				// Tangent space basis for VNDF sampling
				vec3 up = abs(N.z) < 0.999 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
				vec3 tangent = normalize(cross(up, N));
				vec3 bitangent = cross(N, tangent);

				for(uint i = 0u; i < uint(GGX_SAMPLES); i++) {
					vec2 Xi = hammersley(i, uint(GGX_SAMPLES));

					// For PMREM, V = N, so in tangent space V is always (0, 0, 1)
					vec3 H_tangent = importanceSampleGGX_VNDF(Xi, vec3(0.0, 0.0, 1.0), roughness);

					// Transform H back to world space
					vec3 H = normalize(tangent * H_tangent.x + bitangent * H_tangent.y + N * H_tangent.z);
					vec3 L = normalize(2.0 * dot(V, H) * H - V);

					float NdotL = max(dot(N, L), 0.0);

					if(NdotL > 0.0) {
						// Sample environment at fixed mip level
						// VNDF importance sampling handles the distribution filtering
						vec3 sampleColor = bilinearCubeUV(envMap, L, mipInt);

						// Weight by NdotL for the split-sum approximation
						// VNDF PDF naturally accounts for the visible microfacet distribution
						prefilteredColor += sampleColor * NdotL;
						totalWeight += NdotL;
					}
				}

				if (totalWeight > 0.0) {
					prefilteredColor = prefilteredColor / totalWeight;
				}

				gl_FragColor = vec4(prefilteredColor, 1.0);
			}
		`,blending:ki,depthTest:!1,depthWrite:!1})}function zv(i,e,t){let n=new Float32Array(nr),s=new Z(0,1,0);return new Yn({name:"SphericalGaussianBlur",defines:{n:nr,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Tc(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:ki,depthTest:!1,depthWrite:!1})}function sp(){return new Yn({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Tc(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:ki,depthTest:!1,depthWrite:!1})}function rp(){return new Yn({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Tc(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:ki,depthTest:!1,depthWrite:!1})}function Tc(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}var wc=class extends Rn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Go(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Wr(5,5,5),r=new Yn({name:"CubemapFromEquirect",uniforms:Qs(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:In,blending:ki});r.uniforms.tEquirect.value=t;let o=new Mn(s,r),a=t.minFilter;return t.minFilter===Is&&(t.minFilter=gn),new Pl(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}};function Vv(i){let e=new WeakMap,t=new WeakMap,n=null;function s(u,d=!1){return u==null?null:d?o(u):r(u)}function r(u){if(u&&u.isTexture){let d=u.mapping;if(d===Dl||d===Nl)if(e.has(u)){let g=e.get(u).texture;return a(g,u.mapping)}else{let g=u.image;if(g&&g.height>0){let M=new wc(g.height);return M.fromEquirectangularTexture(i,u),e.set(u,M),u.addEventListener("dispose",c),a(M.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture){let d=u.mapping,g=d===Dl||d===Nl,M=d===Rs||d===Ks;if(g||M){let p=t.get(u),m=p!==void 0?p.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==m)return n===null&&(n=new Sc(i)),p=g?n.fromEquirectangular(u,p):n.fromCubemap(u,p),p.texture.pmremVersion=u.pmremVersion,t.set(u,p),p.texture;if(p!==void 0)return p.texture;{let y=u.image;return g&&y&&y.height>0||M&&y&&l(y)?(n===null&&(n=new Sc(i)),p=g?n.fromEquirectangular(u):n.fromCubemap(u),p.texture.pmremVersion=u.pmremVersion,t.set(u,p),u.addEventListener("dispose",h),p.texture):null}}}return u}function a(u,d){return d===Dl?u.mapping=Rs:d===Nl&&(u.mapping=Ks),u}function l(u){let d=0,g=6;for(let M=0;M<g;M++)u[M]!==void 0&&d++;return d===g}function c(u){let d=u.target;d.removeEventListener("dispose",c);let g=e.get(d);g!==void 0&&(e.delete(d),g.dispose())}function h(u){let d=u.target;d.removeEventListener("dispose",h);let g=t.get(d);g!==void 0&&(t.delete(d),g.dispose())}function f(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:f}}function Gv(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Lo("WebGLRenderer: "+n+" extension not supported."),s}}}function Hv(i,e,t,n){let s={},r=new WeakMap;function o(f){let u=f.target;u.index!==null&&e.remove(u.index);for(let g in u.attributes)e.remove(u.attributes[g]);u.removeEventListener("dispose",o),delete s[u.id];let d=r.get(u);d&&(e.remove(d),r.delete(u)),n.releaseStatesOfGeometry(u),u.isInstancedBufferGeometry===!0&&delete u._maxInstanceCount,t.memory.geometries--}function a(f,u){return s[u.id]===!0||(u.addEventListener("dispose",o),s[u.id]=!0,t.memory.geometries++),u}function l(f){let u=f.attributes;for(let d in u)e.update(u[d],i.ARRAY_BUFFER)}function c(f){let u=[],d=f.index,g=f.attributes.position,M=0;if(g===void 0)return;if(d!==null){let y=d.array;M=d.version;for(let A=0,w=y.length;A<w;A+=3){let D=y[A+0],R=y[A+1],N=y[A+2];u.push(D,R,R,N,N,D)}}else{let y=g.array;M=g.version;for(let A=0,w=y.length/3-1;A<w;A+=3){let D=A+0,R=A+1,N=A+2;u.push(D,R,R,N,N,D)}}let p=new(g.count>=65535?Uo:Fo)(u,1);p.version=M;let m=r.get(f);m&&e.remove(m),r.set(f,p)}function h(f){let u=r.get(f);if(u){let d=f.index;d!==null&&u.version<d.version&&c(f)}else c(f);return r.get(f)}return{get:a,update:l,getWireframeAttribute:h}}function Wv(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function c(u,d,g){g!==0&&(i.drawElementsInstanced(n,d,r,u*o,g),t.update(d,n,g))}function h(u,d,g){if(g===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,g);let p=0;for(let m=0;m<g;m++)p+=d[m];t.update(p,n,1)}function f(u,d,g,M){if(g===0)return;let p=e.get("WEBGL_multi_draw");if(p===null)for(let m=0;m<u.length;m++)c(u[m]/o,d[m],M[m]);else{p.multiDrawElementsInstancedWEBGL(n,d,0,r,u,0,M,0,g);let m=0;for(let y=0;y<g;y++)m+=d[y]*M[y];t.update(m,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=f}function Xv(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:Xe("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function qv(i,e,t){let n=new WeakMap,s=new Yt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=h!==void 0?h.length:0,u=n.get(a);if(u===void 0||u.count!==f){let T=function(){N.dispose(),n.delete(a),a.removeEventListener("dispose",T)};u!==void 0&&u.texture.dispose();let d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,M=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],A=0;d===!0&&(A=1),g===!0&&(A=2),M===!0&&(A=3);let w=a.attributes.position.count*A,D=1;w>e.maxTextureSize&&(D=Math.ceil(w/e.maxTextureSize),w=e.maxTextureSize);let R=new Float32Array(w*D*4*f),N=new Do(R,w,D,f);N.type=Zn,N.needsUpdate=!0;let v=A*4;for(let q=0;q<f;q++){let E=p[q],G=m[q],O=y[q],W=w*D*4*q;for(let V=0;V<E.count;V++){let H=V*v;d===!0&&(s.fromBufferAttribute(E,V),R[W+H+0]=s.x,R[W+H+1]=s.y,R[W+H+2]=s.z,R[W+H+3]=0),g===!0&&(s.fromBufferAttribute(G,V),R[W+H+4]=s.x,R[W+H+5]=s.y,R[W+H+6]=s.z,R[W+H+7]=0),M===!0&&(s.fromBufferAttribute(O,V),R[W+H+8]=s.x,R[W+H+9]=s.y,R[W+H+10]=s.z,R[W+H+11]=O.itemSize===4?s.w:1)}}u={count:f,texture:N,size:new Mt(w,D)},n.set(a,u),a.addEventListener("dispose",T)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let d=0;for(let M=0;M<c.length;M++)d+=c[M];let g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function Yv(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,f=c.geometry,u=e.get(c,f);if(r.get(u)!==h&&(e.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==h&&(d.update(),r.set(d,h))}return u}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var $v={[jh]:"LINEAR_TONE_MAPPING",[Qh]:"REINHARD_TONE_MAPPING",[eu]:"CINEON_TONE_MAPPING",[tu]:"ACES_FILMIC_TONE_MAPPING",[iu]:"AGX_TONE_MAPPING",[su]:"NEUTRAL_TONE_MAPPING",[nu]:"CUSTOM_TONE_MAPPING"};function Zv(i,e,t,n,s){let r=new Rn(e,t,{type:i,depthBuffer:n,stencilBuffer:s}),o=new Rn(e,t,{type:zi,depthBuffer:!1,stencilBuffer:!1}),a=new _n;a.setAttribute("position",new ri([-1,3,0,-1,-1,0,3,-1,0],3)),a.setAttribute("uv",new ri([0,2,0,0,2,0],2));let l=new Xr({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),c=new Mn(a,l),h=new Js(-1,1,1,-1,0,1),f=null,u=null,d=!1,g,M=null,p=[],m=!1;this.setSize=function(y,A){r.setSize(y,A),o.setSize(y,A);for(let w=0;w<p.length;w++){let D=p[w];D.setSize&&D.setSize(y,A)}},this.setEffects=function(y){p=y,m=p.length>0&&p[0].isRenderPass===!0;let A=r.width,w=r.height;for(let D=0;D<p.length;D++){let R=p[D];R.setSize&&R.setSize(A,w)}},this.begin=function(y,A){if(d||y.toneMapping===mi&&p.length===0)return!1;if(M=A,A!==null){let w=A.width,D=A.height;(r.width!==w||r.height!==D)&&this.setSize(w,D)}return m===!1&&y.setRenderTarget(r),g=y.toneMapping,y.toneMapping=mi,!0},this.hasRenderPass=function(){return m},this.end=function(y,A){y.toneMapping=g,d=!0;let w=r,D=o;for(let R=0;R<p.length;R++){let N=p[R];if(N.enabled!==!1&&(N.render(y,D,w,A),N.needsSwap!==!1)){let v=w;w=D,D=v}}if(f!==y.outputColorSpace||u!==y.toneMapping){f=y.outputColorSpace,u=y.toneMapping,l.defines={},ut.getTransfer(f)===St&&(l.defines.SRGB_TRANSFER="");let R=$v[u];R&&(l.defines[R]=""),l.needsUpdate=!0}l.uniforms.tDiffuse.value=w.texture,y.setRenderTarget(M),y.render(c,h),M=null,d=!1},this.isCompositing=function(){return d},this.dispose=function(){r.dispose(),o.dispose(),a.dispose(),l.dispose()}}var wp=new On,wu=new As(1,1),Ap=new Do,Tp=new gl,Ep=new Go,op=[],ap=[],lp=new Float32Array(16),cp=new Float32Array(9),hp=new Float32Array(4);function Qr(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=op[s];if(r===void 0&&(r=new Float32Array(s),op[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function nn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function sn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Ec(i,e){let t=ap[e];t===void 0&&(t=new Int32Array(e),ap[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function Jv(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function Kv(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(nn(t,e))return;i.uniform2fv(this.addr,e),sn(t,e)}}function jv(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(nn(t,e))return;i.uniform3fv(this.addr,e),sn(t,e)}}function Qv(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(nn(t,e))return;i.uniform4fv(this.addr,e),sn(t,e)}}function ey(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(nn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),sn(t,e)}else{if(nn(t,n))return;hp.set(n),i.uniformMatrix2fv(this.addr,!1,hp),sn(t,n)}}function ty(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(nn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),sn(t,e)}else{if(nn(t,n))return;cp.set(n),i.uniformMatrix3fv(this.addr,!1,cp),sn(t,n)}}function ny(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(nn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),sn(t,e)}else{if(nn(t,n))return;lp.set(n),i.uniformMatrix4fv(this.addr,!1,lp),sn(t,n)}}function iy(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function sy(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(nn(t,e))return;i.uniform2iv(this.addr,e),sn(t,e)}}function ry(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(nn(t,e))return;i.uniform3iv(this.addr,e),sn(t,e)}}function oy(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(nn(t,e))return;i.uniform4iv(this.addr,e),sn(t,e)}}function ay(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function ly(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(nn(t,e))return;i.uniform2uiv(this.addr,e),sn(t,e)}}function cy(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(nn(t,e))return;i.uniform3uiv(this.addr,e),sn(t,e)}}function hy(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(nn(t,e))return;i.uniform4uiv(this.addr,e),sn(t,e)}}function uy(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(wu.compareFunction=t.isReversedDepthBuffer()?yc:vc,r=wu):r=wp,t.setTexture2D(e||r,s)}function fy(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Tp,s)}function dy(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTextureCube(e||Ep,s)}function py(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Ap,s)}function my(i){switch(i){case 5126:return Jv;case 35664:return Kv;case 35665:return jv;case 35666:return Qv;case 35674:return ey;case 35675:return ty;case 35676:return ny;case 5124:case 35670:return iy;case 35667:case 35671:return sy;case 35668:case 35672:return ry;case 35669:case 35673:return oy;case 5125:return ay;case 36294:return ly;case 36295:return cy;case 36296:return hy;case 35678:case 36198:case 36298:case 36306:case 35682:return uy;case 35679:case 36299:case 36307:return fy;case 35680:case 36300:case 36308:case 36293:return dy;case 36289:case 36303:case 36311:case 36292:return py}}function gy(i,e){i.uniform1fv(this.addr,e)}function _y(i,e){let t=Qr(e,this.size,2);i.uniform2fv(this.addr,t)}function xy(i,e){let t=Qr(e,this.size,3);i.uniform3fv(this.addr,t)}function vy(i,e){let t=Qr(e,this.size,4);i.uniform4fv(this.addr,t)}function yy(i,e){let t=Qr(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function My(i,e){let t=Qr(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function by(i,e){let t=Qr(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function Sy(i,e){i.uniform1iv(this.addr,e)}function wy(i,e){i.uniform2iv(this.addr,e)}function Ay(i,e){i.uniform3iv(this.addr,e)}function Ty(i,e){i.uniform4iv(this.addr,e)}function Ey(i,e){i.uniform1uiv(this.addr,e)}function Cy(i,e){i.uniform2uiv(this.addr,e)}function Ry(i,e){i.uniform3uiv(this.addr,e)}function Iy(i,e){i.uniform4uiv(this.addr,e)}function Py(i,e,t){let n=this.cache,s=e.length,r=Ec(t,s);nn(n,r)||(i.uniform1iv(this.addr,r),sn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=wu:o=wp;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function Ly(i,e,t){let n=this.cache,s=e.length,r=Ec(t,s);nn(n,r)||(i.uniform1iv(this.addr,r),sn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Tp,r[o])}function Dy(i,e,t){let n=this.cache,s=e.length,r=Ec(t,s);nn(n,r)||(i.uniform1iv(this.addr,r),sn(n,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||Ep,r[o])}function Ny(i,e,t){let n=this.cache,s=e.length,r=Ec(t,s);nn(n,r)||(i.uniform1iv(this.addr,r),sn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Ap,r[o])}function Fy(i){switch(i){case 5126:return gy;case 35664:return _y;case 35665:return xy;case 35666:return vy;case 35674:return yy;case 35675:return My;case 35676:return by;case 5124:case 35670:return Sy;case 35667:case 35671:return wy;case 35668:case 35672:return Ay;case 35669:case 35673:return Ty;case 5125:return Ey;case 36294:return Cy;case 36295:return Ry;case 36296:return Iy;case 35678:case 36198:case 36298:case 36306:case 35682:return Py;case 35679:case 36299:case 36307:return Ly;case 35680:case 36300:case 36308:case 36293:return Dy;case 36289:case 36303:case 36311:case 36292:return Ny}}var Au=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=my(t.type)}},Tu=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Fy(t.type)}},Eu=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},bu=/(\w+)(\])?(\[|\.)?/g;function up(i,e){i.seq.push(e),i.map[e.id]=e}function Uy(i,e,t){let n=i.name,s=n.length;for(bu.lastIndex=0;;){let r=bu.exec(n),o=bu.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){up(t,c===void 0?new Au(a,i,e):new Tu(a,i,e));break}else{let f=t.map[a];f===void 0&&(f=new Eu(a),up(t,f)),t=f}}}var jr=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);Uy(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function fp(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var Oy=37297,By=0;function ky(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var dp=new nt;function zy(i){ut._getMatrix(dp,ut.workingColorSpace,i);let e=`mat3( ${dp.elements.map(t=>t.toFixed(4))} )`;switch(ut.getTransfer(i)){case Ro:return[e,"LinearTransferOETF"];case St:return[e,"sRGBTransferOETF"];default:return qe("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function pp(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+ky(i.getShaderSource(e),a)}else return r}function Vy(i,e){let t=zy(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}var Gy={[jh]:"Linear",[Qh]:"Reinhard",[eu]:"Cineon",[tu]:"ACESFilmic",[iu]:"AgX",[su]:"Neutral",[nu]:"Custom"};function Hy(i,e){let t=Gy[e];return t===void 0?(qe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var bc=new Z;function Wy(){ut.getLuminanceCoefficients(bc);let i=bc.x.toFixed(4),e=bc.y.toFixed(4),t=bc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Xy(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(sa).join(`
`)}function qy(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function Yy(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function sa(i){return i!==""}function mp(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function gp(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var $y=/^[ \t]*#include +<([\w\d./]+)>/gm;function Cu(i){return i.replace($y,Jy)}var Zy=new Map;function Jy(i,e){let t=st[e];if(t===void 0){let n=Zy.get(e);if(n!==void 0)t=st[n],qe('WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,n);else throw new Error("Can not resolve #include <"+e+">")}return Cu(t)}var Ky=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function _p(i){return i.replace(Ky,jy)}function jy(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function xp(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var Qy={[Yo]:"SHADOWMAP_TYPE_PCF",[Yr]:"SHADOWMAP_TYPE_VSM"};function eM(i){return Qy[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var tM={[Rs]:"ENVMAP_TYPE_CUBE",[Ks]:"ENVMAP_TYPE_CUBE",[$o]:"ENVMAP_TYPE_CUBE_UV"};function nM(i){return i.envMap===!1?"ENVMAP_TYPE_CUBE":tM[i.envMapMode]||"ENVMAP_TYPE_CUBE"}var iM={[Ks]:"ENVMAP_MODE_REFRACTION"};function sM(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":iM[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var rM={[Kh]:"ENVMAP_BLENDING_MULTIPLY",[Ud]:"ENVMAP_BLENDING_MIX",[Od]:"ENVMAP_BLENDING_ADD"};function oM(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":rM[i.combine]||"ENVMAP_BLENDING_NONE"}function aM(i){let e=i.envMapCubeUVHeight;if(e===null)return null;let t=Math.log2(e)-2,n=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:n,maxMip:t}}function lM(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=eM(t),c=nM(t),h=sM(t),f=oM(t),u=aM(t),d=Xy(t),g=qy(r),M=s.createProgram(),p,m,y=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(sa).join(`
`),p.length>0&&(p+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(sa).join(`
`),m.length>0&&(m+=`
`)):(p=[xp(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(sa).join(`
`),m=[xp(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+f:"",u?"#define CUBEUV_TEXEL_WIDTH "+u.texelWidth:"",u?"#define CUBEUV_TEXEL_HEIGHT "+u.texelHeight:"",u?"#define CUBEUV_MAX_MIP "+u.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==mi?"#define TONE_MAPPING":"",t.toneMapping!==mi?st.tonemapping_pars_fragment:"",t.toneMapping!==mi?Hy("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",st.colorspace_pars_fragment,Vy("linearToOutputTexel",t.outputColorSpace),Wy(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(sa).join(`
`)),o=Cu(o),o=mp(o,t),o=gp(o,t),a=Cu(a),a=mp(a,t),a=gp(a,t),o=_p(o),a=_p(a),t.isRawShaderMaterial!==!0&&(y=`#version 300 es
`,p=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+p,m=["#define varying in",t.glslVersion===ea?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===ea?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let A=y+p+o,w=y+m+a,D=fp(s,s.VERTEX_SHADER,A),R=fp(s,s.FRAGMENT_SHADER,w);s.attachShader(M,D),s.attachShader(M,R),t.index0AttributeName!==void 0?s.bindAttribLocation(M,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(M,0,"position"),s.linkProgram(M);function N(E){if(i.debug.checkShaderErrors){let G=s.getProgramInfoLog(M)||"",O=s.getShaderInfoLog(D)||"",W=s.getShaderInfoLog(R)||"",V=G.trim(),H=O.trim(),U=W.trim(),le=!0,ie=!0;if(s.getProgramParameter(M,s.LINK_STATUS)===!1)if(le=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,M,D,R);else{let ce=pp(s,D,"vertex"),_e=pp(s,R,"fragment");Xe("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(M,s.VALIDATE_STATUS)+`

Material Name: `+E.name+`
Material Type: `+E.type+`

Program Info Log: `+V+`
`+ce+`
`+_e)}else V!==""?qe("WebGLProgram: Program Info Log:",V):(H===""||U==="")&&(ie=!1);ie&&(E.diagnostics={runnable:le,programLog:V,vertexShader:{log:H,prefix:p},fragmentShader:{log:U,prefix:m}})}s.deleteShader(D),s.deleteShader(R),v=new jr(s,M),T=Yy(s,M)}let v;this.getUniforms=function(){return v===void 0&&N(this),v};let T;this.getAttributes=function(){return T===void 0&&N(this),T};let q=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return q===!1&&(q=s.getProgramParameter(M,Oy)),q},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(M),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=By++,this.cacheKey=e,this.usedTimes=1,this.program=M,this.vertexShader=D,this.fragmentShader=R,this}var cM=0,Ru=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){let t=e.vertexShader,n=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(e);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Iu(e),t.set(e,n)),n}},Iu=class{constructor(e){this.id=cM++,this.code=e,this.usedTimes=0}};function hM(i,e,t,n,s,r){let o=new No,a=new Ru,l=new Set,c=[],h=new Map,f=n.logarithmicDepthBuffer,u=n.precision,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function g(v){return l.add(v),v===0?"uv":`uv${v}`}function M(v,T,q,E,G){let O=E.fog,W=G.geometry,V=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?E.environment:null,H=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,U=e.get(v.envMap||V,H),le=U&&U.mapping===$o?U.image.height:null,ie=d[v.type];v.precision!==null&&(u=n.getMaxPrecision(v.precision),u!==v.precision&&qe("WebGLProgram.getParameters:",v.precision,"not supported, using",u,"instead."));let ce=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,_e=ce!==void 0?ce.length:0,oe=0;W.morphAttributes.position!==void 0&&(oe=1),W.morphAttributes.normal!==void 0&&(oe=2),W.morphAttributes.color!==void 0&&(oe=3);let ue,et,it,Q;if(ie){let _t=Gi[ie];ue=_t.vertexShader,et=_t.fragmentShader}else ue=v.vertexShader,et=v.fragmentShader,a.update(v),it=a.getVertexShaderID(v),Q=a.getFragmentShaderID(v);let re=i.getRenderTarget(),me=i.state.buffers.depth.getReversed(),He=G.isInstancedMesh===!0,Se=G.isBatchedMesh===!0,Ge=!!v.map,At=!!v.matcap,Ye=!!U,rt=!!v.aoMap,ht=!!v.lightMap,$e=!!v.bumpMap,Rt=!!v.normalMap,F=!!v.displacementMap,Tt=!!v.emissiveMap,Ze=!!v.metalnessMap,dt=!!v.roughnessMap,Ie=v.anisotropy>0,I=v.clearcoat>0,x=v.dispersion>0,L=v.iridescence>0,K=v.sheen>0,ne=v.transmission>0,ee=Ie&&!!v.anisotropyMap,Pe=I&&!!v.clearcoatMap,ge=I&&!!v.clearcoatNormalMap,Oe=I&&!!v.clearcoatRoughnessMap,Be=L&&!!v.iridescenceMap,ae=L&&!!v.iridescenceThicknessMap,he=K&&!!v.sheenColorMap,we=K&&!!v.sheenRoughnessMap,Ne=!!v.specularMap,Ae=!!v.specularColorMap,Je=!!v.specularIntensityMap,B=ne&&!!v.transmissionMap,ve=ne&&!!v.thicknessMap,fe=!!v.gradientMap,Le=!!v.alphaMap,pe=v.alphaTest>0,te=!!v.alphaHash,Ue=!!v.extensions,Ke=mi;v.toneMapped&&(re===null||re.isXRRenderTarget===!0)&&(Ke=i.toneMapping);let Et={shaderID:ie,shaderType:v.type,shaderName:v.name,vertexShader:ue,fragmentShader:et,defines:v.defines,customVertexShaderID:it,customFragmentShaderID:Q,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:u,batching:Se,batchingColor:Se&&G._colorsTexture!==null,instancing:He,instancingColor:He&&G.instanceColor!==null,instancingMorph:He&&G.morphTexture!==null,outputColorSpace:re===null?i.outputColorSpace:re.isXRRenderTarget===!0?re.texture.colorSpace:Zs,alphaToCoverage:!!v.alphaToCoverage,map:Ge,matcap:At,envMap:Ye,envMapMode:Ye&&U.mapping,envMapCubeUVHeight:le,aoMap:rt,lightMap:ht,bumpMap:$e,normalMap:Rt,displacementMap:F,emissiveMap:Tt,normalMapObjectSpace:Rt&&v.normalMapType===Vd,normalMapTangentSpace:Rt&&v.normalMapType===zd,metalnessMap:Ze,roughnessMap:dt,anisotropy:Ie,anisotropyMap:ee,clearcoat:I,clearcoatMap:Pe,clearcoatNormalMap:ge,clearcoatRoughnessMap:Oe,dispersion:x,iridescence:L,iridescenceMap:Be,iridescenceThicknessMap:ae,sheen:K,sheenColorMap:he,sheenRoughnessMap:we,specularMap:Ne,specularColorMap:Ae,specularIntensityMap:Je,transmission:ne,transmissionMap:B,thicknessMap:ve,gradientMap:fe,opaque:v.transparent===!1&&v.blending===Ys&&v.alphaToCoverage===!1,alphaMap:Le,alphaTest:pe,alphaHash:te,combine:v.combine,mapUv:Ge&&g(v.map.channel),aoMapUv:rt&&g(v.aoMap.channel),lightMapUv:ht&&g(v.lightMap.channel),bumpMapUv:$e&&g(v.bumpMap.channel),normalMapUv:Rt&&g(v.normalMap.channel),displacementMapUv:F&&g(v.displacementMap.channel),emissiveMapUv:Tt&&g(v.emissiveMap.channel),metalnessMapUv:Ze&&g(v.metalnessMap.channel),roughnessMapUv:dt&&g(v.roughnessMap.channel),anisotropyMapUv:ee&&g(v.anisotropyMap.channel),clearcoatMapUv:Pe&&g(v.clearcoatMap.channel),clearcoatNormalMapUv:ge&&g(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Oe&&g(v.clearcoatRoughnessMap.channel),iridescenceMapUv:Be&&g(v.iridescenceMap.channel),iridescenceThicknessMapUv:ae&&g(v.iridescenceThicknessMap.channel),sheenColorMapUv:he&&g(v.sheenColorMap.channel),sheenRoughnessMapUv:we&&g(v.sheenRoughnessMap.channel),specularMapUv:Ne&&g(v.specularMap.channel),specularColorMapUv:Ae&&g(v.specularColorMap.channel),specularIntensityMapUv:Je&&g(v.specularIntensityMap.channel),transmissionMapUv:B&&g(v.transmissionMap.channel),thicknessMapUv:ve&&g(v.thicknessMap.channel),alphaMapUv:Le&&g(v.alphaMap.channel),vertexTangents:!!W.attributes.tangent&&(Rt||Ie),vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,pointsUvs:G.isPoints===!0&&!!W.attributes.uv&&(Ge||Le),fog:!!O,useFog:v.fog===!0,fogExp2:!!O&&O.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||W.attributes.normal===void 0&&Rt===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:me,skinning:G.isSkinnedMesh===!0,morphTargets:W.morphAttributes.position!==void 0,morphNormals:W.morphAttributes.normal!==void 0,morphColors:W.morphAttributes.color!==void 0,morphTargetsCount:_e,morphTextureStride:oe,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:i.shadowMap.enabled&&q.length>0,shadowMapType:i.shadowMap.type,toneMapping:Ke,decodeVideoTexture:Ge&&v.map.isVideoTexture===!0&&ut.getTransfer(v.map.colorSpace)===St,decodeVideoTextureEmissive:Tt&&v.emissiveMap.isVideoTexture===!0&&ut.getTransfer(v.emissiveMap.colorSpace)===St,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Bi,flipSided:v.side===In,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Ue&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ue&&v.extensions.multiDraw===!0||Se)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return Et.vertexUv1s=l.has(1),Et.vertexUv2s=l.has(2),Et.vertexUv3s=l.has(3),l.clear(),Et}function p(v){let T=[];if(v.shaderID?T.push(v.shaderID):(T.push(v.customVertexShaderID),T.push(v.customFragmentShaderID)),v.defines!==void 0)for(let q in v.defines)T.push(q),T.push(v.defines[q]);return v.isRawShaderMaterial===!1&&(m(T,v),y(T,v),T.push(i.outputColorSpace)),T.push(v.customProgramCacheKey),T.join()}function m(v,T){v.push(T.precision),v.push(T.outputColorSpace),v.push(T.envMapMode),v.push(T.envMapCubeUVHeight),v.push(T.mapUv),v.push(T.alphaMapUv),v.push(T.lightMapUv),v.push(T.aoMapUv),v.push(T.bumpMapUv),v.push(T.normalMapUv),v.push(T.displacementMapUv),v.push(T.emissiveMapUv),v.push(T.metalnessMapUv),v.push(T.roughnessMapUv),v.push(T.anisotropyMapUv),v.push(T.clearcoatMapUv),v.push(T.clearcoatNormalMapUv),v.push(T.clearcoatRoughnessMapUv),v.push(T.iridescenceMapUv),v.push(T.iridescenceThicknessMapUv),v.push(T.sheenColorMapUv),v.push(T.sheenRoughnessMapUv),v.push(T.specularMapUv),v.push(T.specularColorMapUv),v.push(T.specularIntensityMapUv),v.push(T.transmissionMapUv),v.push(T.thicknessMapUv),v.push(T.combine),v.push(T.fogExp2),v.push(T.sizeAttenuation),v.push(T.morphTargetsCount),v.push(T.morphAttributeCount),v.push(T.numDirLights),v.push(T.numPointLights),v.push(T.numSpotLights),v.push(T.numSpotLightMaps),v.push(T.numHemiLights),v.push(T.numRectAreaLights),v.push(T.numDirLightShadows),v.push(T.numPointLightShadows),v.push(T.numSpotLightShadows),v.push(T.numSpotLightShadowsWithMaps),v.push(T.numLightProbes),v.push(T.shadowMapType),v.push(T.toneMapping),v.push(T.numClippingPlanes),v.push(T.numClipIntersection),v.push(T.depthPacking)}function y(v,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),v.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),v.push(o.mask)}function A(v){let T=d[v.type],q;if(T){let E=Gi[T];q=Qd.clone(E.uniforms)}else q=v.uniforms;return q}function w(v,T){let q=h.get(T);return q!==void 0?++q.usedTimes:(q=new lM(i,T,v,s),c.push(q),h.set(T,q)),q}function D(v){if(--v.usedTimes===0){let T=c.indexOf(v);c[T]=c[c.length-1],c.pop(),h.delete(v.cacheKey),v.destroy()}}function R(v){a.remove(v)}function N(){a.dispose()}return{getParameters:M,getProgramCacheKey:p,getUniforms:A,acquireProgram:w,releaseProgram:D,releaseShaderCache:R,programs:c,dispose:N}}function uM(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function fM(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function vp(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function yp(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(u){let d=0;return u.isInstancedMesh&&(d+=2),u.isSkinnedMesh&&(d+=1),d}function a(u,d,g,M,p,m){let y=i[e];return y===void 0?(y={id:u.id,object:u,geometry:d,material:g,materialVariant:o(u),groupOrder:M,renderOrder:u.renderOrder,z:p,group:m},i[e]=y):(y.id=u.id,y.object=u,y.geometry=d,y.material=g,y.materialVariant=o(u),y.groupOrder=M,y.renderOrder=u.renderOrder,y.z=p,y.group=m),e++,y}function l(u,d,g,M,p,m){let y=a(u,d,g,M,p,m);g.transmission>0?n.push(y):g.transparent===!0?s.push(y):t.push(y)}function c(u,d,g,M,p,m){let y=a(u,d,g,M,p,m);g.transmission>0?n.unshift(y):g.transparent===!0?s.unshift(y):t.unshift(y)}function h(u,d){t.length>1&&t.sort(u||fM),n.length>1&&n.sort(d||vp),s.length>1&&s.sort(d||vp)}function f(){for(let u=e,d=i.length;u<d;u++){let g=i[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:f,sort:h}}function dM(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new yp,i.set(n,[o])):s>=r.length?(o=new yp,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function pM(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new Z,color:new ft};break;case"SpotLight":t={position:new Z,direction:new Z,color:new ft,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new Z,color:new ft,distance:0,decay:0};break;case"HemisphereLight":t={direction:new Z,skyColor:new ft,groundColor:new ft};break;case"RectAreaLight":t={color:new ft,position:new Z,halfWidth:new Z,halfHeight:new Z};break}return i[e.id]=t,t}}}function mM(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Mt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Mt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Mt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var gM=0;function _M(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function xM(i){let e=new pM,t=mM(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new Z);let s=new Z,r=new $t,o=new $t;function a(c){let h=0,f=0,u=0;for(let T=0;T<9;T++)n.probe[T].set(0,0,0);let d=0,g=0,M=0,p=0,m=0,y=0,A=0,w=0,D=0,R=0,N=0;c.sort(_M);for(let T=0,q=c.length;T<q;T++){let E=c[T],G=E.color,O=E.intensity,W=E.distance,V=null;if(E.shadow&&E.shadow.map&&(E.shadow.map.texture.format===js?V=E.shadow.map.texture:V=E.shadow.map.depthTexture||E.shadow.map.texture),E.isAmbientLight)h+=G.r*O,f+=G.g*O,u+=G.b*O;else if(E.isLightProbe){for(let H=0;H<9;H++)n.probe[H].addScaledVector(E.sh.coefficients[H],O);N++}else if(E.isDirectionalLight){let H=e.get(E);if(H.color.copy(E.color).multiplyScalar(E.intensity),E.castShadow){let U=E.shadow,le=t.get(E);le.shadowIntensity=U.intensity,le.shadowBias=U.bias,le.shadowNormalBias=U.normalBias,le.shadowRadius=U.radius,le.shadowMapSize=U.mapSize,n.directionalShadow[d]=le,n.directionalShadowMap[d]=V,n.directionalShadowMatrix[d]=E.shadow.matrix,y++}n.directional[d]=H,d++}else if(E.isSpotLight){let H=e.get(E);H.position.setFromMatrixPosition(E.matrixWorld),H.color.copy(G).multiplyScalar(O),H.distance=W,H.coneCos=Math.cos(E.angle),H.penumbraCos=Math.cos(E.angle*(1-E.penumbra)),H.decay=E.decay,n.spot[M]=H;let U=E.shadow;if(E.map&&(n.spotLightMap[D]=E.map,D++,U.updateMatrices(E),E.castShadow&&R++),n.spotLightMatrix[M]=U.matrix,E.castShadow){let le=t.get(E);le.shadowIntensity=U.intensity,le.shadowBias=U.bias,le.shadowNormalBias=U.normalBias,le.shadowRadius=U.radius,le.shadowMapSize=U.mapSize,n.spotShadow[M]=le,n.spotShadowMap[M]=V,w++}M++}else if(E.isRectAreaLight){let H=e.get(E);H.color.copy(G).multiplyScalar(O),H.halfWidth.set(E.width*.5,0,0),H.halfHeight.set(0,E.height*.5,0),n.rectArea[p]=H,p++}else if(E.isPointLight){let H=e.get(E);if(H.color.copy(E.color).multiplyScalar(E.intensity),H.distance=E.distance,H.decay=E.decay,E.castShadow){let U=E.shadow,le=t.get(E);le.shadowIntensity=U.intensity,le.shadowBias=U.bias,le.shadowNormalBias=U.normalBias,le.shadowRadius=U.radius,le.shadowMapSize=U.mapSize,le.shadowCameraNear=U.camera.near,le.shadowCameraFar=U.camera.far,n.pointShadow[g]=le,n.pointShadowMap[g]=V,n.pointShadowMatrix[g]=E.shadow.matrix,A++}n.point[g]=H,g++}else if(E.isHemisphereLight){let H=e.get(E);H.skyColor.copy(E.color).multiplyScalar(O),H.groundColor.copy(E.groundColor).multiplyScalar(O),n.hemi[m]=H,m++}}p>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=be.LTC_FLOAT_1,n.rectAreaLTC2=be.LTC_FLOAT_2):(n.rectAreaLTC1=be.LTC_HALF_1,n.rectAreaLTC2=be.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=f,n.ambient[2]=u;let v=n.hash;(v.directionalLength!==d||v.pointLength!==g||v.spotLength!==M||v.rectAreaLength!==p||v.hemiLength!==m||v.numDirectionalShadows!==y||v.numPointShadows!==A||v.numSpotShadows!==w||v.numSpotMaps!==D||v.numLightProbes!==N)&&(n.directional.length=d,n.spot.length=M,n.rectArea.length=p,n.point.length=g,n.hemi.length=m,n.directionalShadow.length=y,n.directionalShadowMap.length=y,n.pointShadow.length=A,n.pointShadowMap.length=A,n.spotShadow.length=w,n.spotShadowMap.length=w,n.directionalShadowMatrix.length=y,n.pointShadowMatrix.length=A,n.spotLightMatrix.length=w+D-R,n.spotLightMap.length=D,n.numSpotLightShadowsWithMaps=R,n.numLightProbes=N,v.directionalLength=d,v.pointLength=g,v.spotLength=M,v.rectAreaLength=p,v.hemiLength=m,v.numDirectionalShadows=y,v.numPointShadows=A,v.numSpotShadows=w,v.numSpotMaps=D,v.numLightProbes=N,n.version=gM++)}function l(c,h){let f=0,u=0,d=0,g=0,M=0,p=h.matrixWorldInverse;for(let m=0,y=c.length;m<y;m++){let A=c[m];if(A.isDirectionalLight){let w=n.directional[f];w.direction.setFromMatrixPosition(A.matrixWorld),s.setFromMatrixPosition(A.target.matrixWorld),w.direction.sub(s),w.direction.transformDirection(p),f++}else if(A.isSpotLight){let w=n.spot[d];w.position.setFromMatrixPosition(A.matrixWorld),w.position.applyMatrix4(p),w.direction.setFromMatrixPosition(A.matrixWorld),s.setFromMatrixPosition(A.target.matrixWorld),w.direction.sub(s),w.direction.transformDirection(p),d++}else if(A.isRectAreaLight){let w=n.rectArea[g];w.position.setFromMatrixPosition(A.matrixWorld),w.position.applyMatrix4(p),o.identity(),r.copy(A.matrixWorld),r.premultiply(p),o.extractRotation(r),w.halfWidth.set(A.width*.5,0,0),w.halfHeight.set(0,A.height*.5,0),w.halfWidth.applyMatrix4(o),w.halfHeight.applyMatrix4(o),g++}else if(A.isPointLight){let w=n.point[u];w.position.setFromMatrixPosition(A.matrixWorld),w.position.applyMatrix4(p),u++}else if(A.isHemisphereLight){let w=n.hemi[M];w.direction.setFromMatrixPosition(A.matrixWorld),w.direction.transformDirection(p),M++}}}return{setup:a,setupView:l,state:n}}function Mp(i){let e=new xM(i),t=[],n=[];function s(h){c.camera=h,t.length=0,n.length=0}function r(h){t.push(h)}function o(h){n.push(h)}function a(){e.setup(t)}function l(h){e.setupView(t,h)}let c={lightsArray:t,shadowsArray:n,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function vM(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Mp(i),e.set(s,[a])):r>=o.length?(a=new Mp(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var yM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,MM=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,bM=[new Z(1,0,0),new Z(-1,0,0),new Z(0,1,0),new Z(0,-1,0),new Z(0,0,1),new Z(0,0,-1)],SM=[new Z(0,-1,0),new Z(0,-1,0),new Z(0,0,1),new Z(0,0,-1),new Z(0,-1,0),new Z(0,-1,0)],bp=new $t,ia=new Z,Su=new Z;function wM(i,e,t){let n=new zo,s=new Mt,r=new Mt,o=new Yt,a=new vl,l=new yl,c={},h=t.maxTextureSize,f={[ji]:In,[In]:ji,[Bi]:Bi},u=new Yn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Mt},radius:{value:4}},vertexShader:yM,fragmentShader:MM}),d=u.clone();d.defines.HORIZONTAL_PASS=1;let g=new _n;g.setAttribute("position",new mn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let M=new Mn(g,u),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Yo;let m=this.type;this.render=function(R,N,v){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||R.length===0)return;this.type===_d&&(qe("WebGLShadowMap: PCFSoftShadowMap has been deprecated. Using PCFShadowMap instead."),this.type=Yo);let T=i.getRenderTarget(),q=i.getActiveCubeFace(),E=i.getActiveMipmapLevel(),G=i.state;G.setBlending(ki),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let O=m!==this.type;O&&N.traverse(function(W){W.material&&(Array.isArray(W.material)?W.material.forEach(V=>V.needsUpdate=!0):W.material.needsUpdate=!0)});for(let W=0,V=R.length;W<V;W++){let H=R[W],U=H.shadow;if(U===void 0){qe("WebGLShadowMap:",H,"has no shadow.");continue}if(U.autoUpdate===!1&&U.needsUpdate===!1)continue;s.copy(U.mapSize);let le=U.getFrameExtents();s.multiply(le),r.copy(U.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/le.x),s.x=r.x*le.x,U.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/le.y),s.y=r.y*le.y,U.mapSize.y=r.y));let ie=i.state.buffers.depth.getReversed();if(U.camera._reversedDepth=ie,U.map===null||O===!0){if(U.map!==null&&(U.map.depthTexture!==null&&(U.map.depthTexture.dispose(),U.map.depthTexture=null),U.map.dispose()),this.type===Yr){if(H.isPointLight){qe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}U.map=new Rn(s.x,s.y,{format:js,type:zi,minFilter:gn,magFilter:gn,generateMipmaps:!1}),U.map.texture.name=H.name+".shadowMap",U.map.depthTexture=new As(s.x,s.y,Zn),U.map.depthTexture.name=H.name+".shadowMapDepth",U.map.depthTexture.format=Fi,U.map.depthTexture.compareFunction=null,U.map.depthTexture.minFilter=Qt,U.map.depthTexture.magFilter=Qt}else H.isPointLight?(U.map=new wc(s.x),U.map.depthTexture=new xl(s.x,gi)):(U.map=new Rn(s.x,s.y),U.map.depthTexture=new As(s.x,s.y,gi)),U.map.depthTexture.name=H.name+".shadowMap",U.map.depthTexture.format=Fi,this.type===Yo?(U.map.depthTexture.compareFunction=ie?yc:vc,U.map.depthTexture.minFilter=gn,U.map.depthTexture.magFilter=gn):(U.map.depthTexture.compareFunction=null,U.map.depthTexture.minFilter=Qt,U.map.depthTexture.magFilter=Qt);U.camera.updateProjectionMatrix()}let ce=U.map.isWebGLCubeRenderTarget?6:1;for(let _e=0;_e<ce;_e++){if(U.map.isWebGLCubeRenderTarget)i.setRenderTarget(U.map,_e),i.clear();else{_e===0&&(i.setRenderTarget(U.map),i.clear());let oe=U.getViewport(_e);o.set(r.x*oe.x,r.y*oe.y,r.x*oe.z,r.y*oe.w),G.viewport(o)}if(H.isPointLight){let oe=U.camera,ue=U.matrix,et=H.distance||oe.far;et!==oe.far&&(oe.far=et,oe.updateProjectionMatrix()),ia.setFromMatrixPosition(H.matrixWorld),oe.position.copy(ia),Su.copy(oe.position),Su.add(bM[_e]),oe.up.copy(SM[_e]),oe.lookAt(Su),oe.updateMatrixWorld(),ue.makeTranslation(-ia.x,-ia.y,-ia.z),bp.multiplyMatrices(oe.projectionMatrix,oe.matrixWorldInverse),U._frustum.setFromProjectionMatrix(bp,oe.coordinateSystem,oe.reversedDepth)}else U.updateMatrices(H);n=U.getFrustum(),w(N,v,U.camera,H,this.type)}U.isPointLightShadow!==!0&&this.type===Yr&&y(U,v),U.needsUpdate=!1}m=this.type,p.needsUpdate=!1,i.setRenderTarget(T,q,E)};function y(R,N){let v=e.update(M);u.defines.VSM_SAMPLES!==R.blurSamples&&(u.defines.VSM_SAMPLES=R.blurSamples,d.defines.VSM_SAMPLES=R.blurSamples,u.needsUpdate=!0,d.needsUpdate=!0),R.mapPass===null&&(R.mapPass=new Rn(s.x,s.y,{format:js,type:zi})),u.uniforms.shadow_pass.value=R.map.depthTexture,u.uniforms.resolution.value=R.mapSize,u.uniforms.radius.value=R.radius,i.setRenderTarget(R.mapPass),i.clear(),i.renderBufferDirect(N,null,v,u,M,null),d.uniforms.shadow_pass.value=R.mapPass.texture,d.uniforms.resolution.value=R.mapSize,d.uniforms.radius.value=R.radius,i.setRenderTarget(R.map),i.clear(),i.renderBufferDirect(N,null,v,d,M,null)}function A(R,N,v,T){let q=null,E=v.isPointLight===!0?R.customDistanceMaterial:R.customDepthMaterial;if(E!==void 0)q=E;else if(q=v.isPointLight===!0?l:a,i.localClippingEnabled&&N.clipShadows===!0&&Array.isArray(N.clippingPlanes)&&N.clippingPlanes.length!==0||N.displacementMap&&N.displacementScale!==0||N.alphaMap&&N.alphaTest>0||N.map&&N.alphaTest>0||N.alphaToCoverage===!0){let G=q.uuid,O=N.uuid,W=c[G];W===void 0&&(W={},c[G]=W);let V=W[O];V===void 0&&(V=q.clone(),W[O]=V,N.addEventListener("dispose",D)),q=V}if(q.visible=N.visible,q.wireframe=N.wireframe,T===Yr?q.side=N.shadowSide!==null?N.shadowSide:N.side:q.side=N.shadowSide!==null?N.shadowSide:f[N.side],q.alphaMap=N.alphaMap,q.alphaTest=N.alphaToCoverage===!0?.5:N.alphaTest,q.map=N.map,q.clipShadows=N.clipShadows,q.clippingPlanes=N.clippingPlanes,q.clipIntersection=N.clipIntersection,q.displacementMap=N.displacementMap,q.displacementScale=N.displacementScale,q.displacementBias=N.displacementBias,q.wireframeLinewidth=N.wireframeLinewidth,q.linewidth=N.linewidth,v.isPointLight===!0&&q.isMeshDistanceMaterial===!0){let G=i.properties.get(q);G.light=v}return q}function w(R,N,v,T,q){if(R.visible===!1)return;if(R.layers.test(N.layers)&&(R.isMesh||R.isLine||R.isPoints)&&(R.castShadow||R.receiveShadow&&q===Yr)&&(!R.frustumCulled||n.intersectsObject(R))){R.modelViewMatrix.multiplyMatrices(v.matrixWorldInverse,R.matrixWorld);let O=e.update(R),W=R.material;if(Array.isArray(W)){let V=O.groups;for(let H=0,U=V.length;H<U;H++){let le=V[H],ie=W[le.materialIndex];if(ie&&ie.visible){let ce=A(R,ie,T,q);R.onBeforeShadow(i,R,N,v,O,ce,le),i.renderBufferDirect(v,null,O,ce,R,le),R.onAfterShadow(i,R,N,v,O,ce,le)}}}else if(W.visible){let V=A(R,W,T,q);R.onBeforeShadow(i,R,N,v,O,V,null),i.renderBufferDirect(v,null,O,V,R,null),R.onAfterShadow(i,R,N,v,O,V,null)}}let G=R.children;for(let O=0,W=G.length;O<W;O++)w(G[O],N,v,T,q)}function D(R){R.target.removeEventListener("dispose",D);for(let v in c){let T=c[v],q=R.target.uuid;q in T&&(T[q].dispose(),delete T[q])}}}function AM(i,e){function t(){let B=!1,ve=new Yt,fe=null,Le=new Yt(0,0,0,0);return{setMask:function(pe){fe!==pe&&!B&&(i.colorMask(pe,pe,pe,pe),fe=pe)},setLocked:function(pe){B=pe},setClear:function(pe,te,Ue,Ke,Et){Et===!0&&(pe*=Ke,te*=Ke,Ue*=Ke),ve.set(pe,te,Ue,Ke),Le.equals(ve)===!1&&(i.clearColor(pe,te,Ue,Ke),Le.copy(ve))},reset:function(){B=!1,fe=null,Le.set(-1,0,0,0)}}}function n(){let B=!1,ve=!1,fe=null,Le=null,pe=null;return{setReversed:function(te){if(ve!==te){let Ue=e.get("EXT_clip_control");te?Ue.clipControlEXT(Ue.LOWER_LEFT_EXT,Ue.ZERO_TO_ONE_EXT):Ue.clipControlEXT(Ue.LOWER_LEFT_EXT,Ue.NEGATIVE_ONE_TO_ONE_EXT),ve=te;let Ke=pe;pe=null,this.setClear(Ke)}},getReversed:function(){return ve},setTest:function(te){te?re(i.DEPTH_TEST):me(i.DEPTH_TEST)},setMask:function(te){fe!==te&&!B&&(i.depthMask(te),fe=te)},setFunc:function(te){if(ve&&(te=Kd[te]),Le!==te){switch(te){case il:i.depthFunc(i.NEVER);break;case sl:i.depthFunc(i.ALWAYS);break;case rl:i.depthFunc(i.LESS);break;case $s:i.depthFunc(i.LEQUAL);break;case ol:i.depthFunc(i.EQUAL);break;case al:i.depthFunc(i.GEQUAL);break;case ll:i.depthFunc(i.GREATER);break;case cl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Le=te}},setLocked:function(te){B=te},setClear:function(te){pe!==te&&(pe=te,ve&&(te=1-te),i.clearDepth(te))},reset:function(){B=!1,fe=null,Le=null,pe=null,ve=!1}}}function s(){let B=!1,ve=null,fe=null,Le=null,pe=null,te=null,Ue=null,Ke=null,Et=null;return{setTest:function(_t){B||(_t?re(i.STENCIL_TEST):me(i.STENCIL_TEST))},setMask:function(_t){ve!==_t&&!B&&(i.stencilMask(_t),ve=_t)},setFunc:function(_t,dn,Lt){(fe!==_t||Le!==dn||pe!==Lt)&&(i.stencilFunc(_t,dn,Lt),fe=_t,Le=dn,pe=Lt)},setOp:function(_t,dn,Lt){(te!==_t||Ue!==dn||Ke!==Lt)&&(i.stencilOp(_t,dn,Lt),te=_t,Ue=dn,Ke=Lt)},setLocked:function(_t){B=_t},setClear:function(_t){Et!==_t&&(i.clearStencil(_t),Et=_t)},reset:function(){B=!1,ve=null,fe=null,Le=null,pe=null,te=null,Ue=null,Ke=null,Et=null}}}let r=new t,o=new n,a=new s,l=new WeakMap,c=new WeakMap,h={},f={},u=new WeakMap,d=[],g=null,M=!1,p=null,m=null,y=null,A=null,w=null,D=null,R=null,N=new ft(0,0,0),v=0,T=!1,q=null,E=null,G=null,O=null,W=null,V=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,U=0,le=i.getParameter(i.VERSION);le.indexOf("WebGL")!==-1?(U=parseFloat(/^WebGL (\d)/.exec(le)[1]),H=U>=1):le.indexOf("OpenGL ES")!==-1&&(U=parseFloat(/^OpenGL ES (\d)/.exec(le)[1]),H=U>=2);let ie=null,ce={},_e=i.getParameter(i.SCISSOR_BOX),oe=i.getParameter(i.VIEWPORT),ue=new Yt().fromArray(_e),et=new Yt().fromArray(oe);function it(B,ve,fe,Le){let pe=new Uint8Array(4),te=i.createTexture();i.bindTexture(B,te),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ue=0;Ue<fe;Ue++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(ve,0,i.RGBA,1,1,Le,0,i.RGBA,i.UNSIGNED_BYTE,pe):i.texImage2D(ve+Ue,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,pe);return te}let Q={};Q[i.TEXTURE_2D]=it(i.TEXTURE_2D,i.TEXTURE_2D,1),Q[i.TEXTURE_CUBE_MAP]=it(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Q[i.TEXTURE_2D_ARRAY]=it(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Q[i.TEXTURE_3D]=it(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),re(i.DEPTH_TEST),o.setFunc($s),$e(!1),Rt(Yh),re(i.CULL_FACE),rt(ki);function re(B){h[B]!==!0&&(i.enable(B),h[B]=!0)}function me(B){h[B]!==!1&&(i.disable(B),h[B]=!1)}function He(B,ve){return f[B]!==ve?(i.bindFramebuffer(B,ve),f[B]=ve,B===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=ve),B===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=ve),!0):!1}function Se(B,ve){let fe=d,Le=!1;if(B){fe=u.get(ve),fe===void 0&&(fe=[],u.set(ve,fe));let pe=B.textures;if(fe.length!==pe.length||fe[0]!==i.COLOR_ATTACHMENT0){for(let te=0,Ue=pe.length;te<Ue;te++)fe[te]=i.COLOR_ATTACHMENT0+te;fe.length=pe.length,Le=!0}}else fe[0]!==i.BACK&&(fe[0]=i.BACK,Le=!0);Le&&i.drawBuffers(fe)}function Ge(B){return g!==B?(i.useProgram(B),g=B,!0):!1}let At={[Ms]:i.FUNC_ADD,[vd]:i.FUNC_SUBTRACT,[yd]:i.FUNC_REVERSE_SUBTRACT};At[Md]=i.MIN,At[bd]=i.MAX;let Ye={[Sd]:i.ZERO,[wd]:i.ONE,[Ad]:i.SRC_COLOR,[tl]:i.SRC_ALPHA,[Pd]:i.SRC_ALPHA_SATURATE,[Rd]:i.DST_COLOR,[Ed]:i.DST_ALPHA,[Td]:i.ONE_MINUS_SRC_COLOR,[nl]:i.ONE_MINUS_SRC_ALPHA,[Id]:i.ONE_MINUS_DST_COLOR,[Cd]:i.ONE_MINUS_DST_ALPHA,[Ld]:i.CONSTANT_COLOR,[Dd]:i.ONE_MINUS_CONSTANT_COLOR,[Nd]:i.CONSTANT_ALPHA,[Fd]:i.ONE_MINUS_CONSTANT_ALPHA};function rt(B,ve,fe,Le,pe,te,Ue,Ke,Et,_t){if(B===ki){M===!0&&(me(i.BLEND),M=!1);return}if(M===!1&&(re(i.BLEND),M=!0),B!==xd){if(B!==p||_t!==T){if((m!==Ms||w!==Ms)&&(i.blendEquation(i.FUNC_ADD),m=Ms,w=Ms),_t)switch(B){case Ys:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case $h:i.blendFunc(i.ONE,i.ONE);break;case Zh:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Jh:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Xe("WebGLState: Invalid blending: ",B);break}else switch(B){case Ys:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case $h:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Zh:Xe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Jh:Xe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Xe("WebGLState: Invalid blending: ",B);break}y=null,A=null,D=null,R=null,N.set(0,0,0),v=0,p=B,T=_t}return}pe=pe||ve,te=te||fe,Ue=Ue||Le,(ve!==m||pe!==w)&&(i.blendEquationSeparate(At[ve],At[pe]),m=ve,w=pe),(fe!==y||Le!==A||te!==D||Ue!==R)&&(i.blendFuncSeparate(Ye[fe],Ye[Le],Ye[te],Ye[Ue]),y=fe,A=Le,D=te,R=Ue),(Ke.equals(N)===!1||Et!==v)&&(i.blendColor(Ke.r,Ke.g,Ke.b,Et),N.copy(Ke),v=Et),p=B,T=!1}function ht(B,ve){B.side===Bi?me(i.CULL_FACE):re(i.CULL_FACE);let fe=B.side===In;ve&&(fe=!fe),$e(fe),B.blending===Ys&&B.transparent===!1?rt(ki):rt(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let Le=B.stencilWrite;a.setTest(Le),Le&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),Tt(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?re(i.SAMPLE_ALPHA_TO_COVERAGE):me(i.SAMPLE_ALPHA_TO_COVERAGE)}function $e(B){q!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),q=B)}function Rt(B){B!==md?(re(i.CULL_FACE),B!==E&&(B===Yh?i.cullFace(i.BACK):B===gd?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):me(i.CULL_FACE),E=B}function F(B){B!==G&&(H&&i.lineWidth(B),G=B)}function Tt(B,ve,fe){B?(re(i.POLYGON_OFFSET_FILL),(O!==ve||W!==fe)&&(O=ve,W=fe,o.getReversed()&&(ve=-ve),i.polygonOffset(ve,fe))):me(i.POLYGON_OFFSET_FILL)}function Ze(B){B?re(i.SCISSOR_TEST):me(i.SCISSOR_TEST)}function dt(B){B===void 0&&(B=i.TEXTURE0+V-1),ie!==B&&(i.activeTexture(B),ie=B)}function Ie(B,ve,fe){fe===void 0&&(ie===null?fe=i.TEXTURE0+V-1:fe=ie);let Le=ce[fe];Le===void 0&&(Le={type:void 0,texture:void 0},ce[fe]=Le),(Le.type!==B||Le.texture!==ve)&&(ie!==fe&&(i.activeTexture(fe),ie=fe),i.bindTexture(B,ve||Q[B]),Le.type=B,Le.texture=ve)}function I(){let B=ce[ie];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function x(){try{i.compressedTexImage2D(...arguments)}catch(B){Xe("WebGLState:",B)}}function L(){try{i.compressedTexImage3D(...arguments)}catch(B){Xe("WebGLState:",B)}}function K(){try{i.texSubImage2D(...arguments)}catch(B){Xe("WebGLState:",B)}}function ne(){try{i.texSubImage3D(...arguments)}catch(B){Xe("WebGLState:",B)}}function ee(){try{i.compressedTexSubImage2D(...arguments)}catch(B){Xe("WebGLState:",B)}}function Pe(){try{i.compressedTexSubImage3D(...arguments)}catch(B){Xe("WebGLState:",B)}}function ge(){try{i.texStorage2D(...arguments)}catch(B){Xe("WebGLState:",B)}}function Oe(){try{i.texStorage3D(...arguments)}catch(B){Xe("WebGLState:",B)}}function Be(){try{i.texImage2D(...arguments)}catch(B){Xe("WebGLState:",B)}}function ae(){try{i.texImage3D(...arguments)}catch(B){Xe("WebGLState:",B)}}function he(B){ue.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),ue.copy(B))}function we(B){et.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),et.copy(B))}function Ne(B,ve){let fe=c.get(ve);fe===void 0&&(fe=new WeakMap,c.set(ve,fe));let Le=fe.get(B);Le===void 0&&(Le=i.getUniformBlockIndex(ve,B.name),fe.set(B,Le))}function Ae(B,ve){let Le=c.get(ve).get(B);l.get(ve)!==Le&&(i.uniformBlockBinding(ve,Le,B.__bindingPointIndex),l.set(ve,Le))}function Je(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),h={},ie=null,ce={},f={},u=new WeakMap,d=[],g=null,M=!1,p=null,m=null,y=null,A=null,w=null,D=null,R=null,N=new ft(0,0,0),v=0,T=!1,q=null,E=null,G=null,O=null,W=null,ue.set(0,0,i.canvas.width,i.canvas.height),et.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:re,disable:me,bindFramebuffer:He,drawBuffers:Se,useProgram:Ge,setBlending:rt,setMaterial:ht,setFlipSided:$e,setCullFace:Rt,setLineWidth:F,setPolygonOffset:Tt,setScissorTest:Ze,activeTexture:dt,bindTexture:Ie,unbindTexture:I,compressedTexImage2D:x,compressedTexImage3D:L,texImage2D:Be,texImage3D:ae,updateUBOMapping:Ne,uniformBlockBinding:Ae,texStorage2D:ge,texStorage3D:Oe,texSubImage2D:K,texSubImage3D:ne,compressedTexSubImage2D:ee,compressedTexSubImage3D:Pe,scissor:he,viewport:we,reset:Je}}function TM(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Mt,h=new WeakMap,f,u=new WeakMap,d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(I,x){return d?new OffscreenCanvas(I,x):Po("canvas")}function M(I,x,L){let K=1,ne=Ie(I);if((ne.width>L||ne.height>L)&&(K=L/Math.max(ne.width,ne.height)),K<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let ee=Math.floor(K*ne.width),Pe=Math.floor(K*ne.height);f===void 0&&(f=g(ee,Pe));let ge=x?g(ee,Pe):f;return ge.width=ee,ge.height=Pe,ge.getContext("2d").drawImage(I,0,0,ee,Pe),qe("WebGLRenderer: Texture has been resized from ("+ne.width+"x"+ne.height+") to ("+ee+"x"+Pe+")."),ge}else return"data"in I&&qe("WebGLRenderer: Image in DataTexture is too big ("+ne.width+"x"+ne.height+")."),I;return I}function p(I){return I.generateMipmaps}function m(I){i.generateMipmap(I)}function y(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function A(I,x,L,K,ne=!1){if(I!==null){if(i[I]!==void 0)return i[I];qe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let ee=x;if(x===i.RED&&(L===i.FLOAT&&(ee=i.R32F),L===i.HALF_FLOAT&&(ee=i.R16F),L===i.UNSIGNED_BYTE&&(ee=i.R8)),x===i.RED_INTEGER&&(L===i.UNSIGNED_BYTE&&(ee=i.R8UI),L===i.UNSIGNED_SHORT&&(ee=i.R16UI),L===i.UNSIGNED_INT&&(ee=i.R32UI),L===i.BYTE&&(ee=i.R8I),L===i.SHORT&&(ee=i.R16I),L===i.INT&&(ee=i.R32I)),x===i.RG&&(L===i.FLOAT&&(ee=i.RG32F),L===i.HALF_FLOAT&&(ee=i.RG16F),L===i.UNSIGNED_BYTE&&(ee=i.RG8)),x===i.RG_INTEGER&&(L===i.UNSIGNED_BYTE&&(ee=i.RG8UI),L===i.UNSIGNED_SHORT&&(ee=i.RG16UI),L===i.UNSIGNED_INT&&(ee=i.RG32UI),L===i.BYTE&&(ee=i.RG8I),L===i.SHORT&&(ee=i.RG16I),L===i.INT&&(ee=i.RG32I)),x===i.RGB_INTEGER&&(L===i.UNSIGNED_BYTE&&(ee=i.RGB8UI),L===i.UNSIGNED_SHORT&&(ee=i.RGB16UI),L===i.UNSIGNED_INT&&(ee=i.RGB32UI),L===i.BYTE&&(ee=i.RGB8I),L===i.SHORT&&(ee=i.RGB16I),L===i.INT&&(ee=i.RGB32I)),x===i.RGBA_INTEGER&&(L===i.UNSIGNED_BYTE&&(ee=i.RGBA8UI),L===i.UNSIGNED_SHORT&&(ee=i.RGBA16UI),L===i.UNSIGNED_INT&&(ee=i.RGBA32UI),L===i.BYTE&&(ee=i.RGBA8I),L===i.SHORT&&(ee=i.RGBA16I),L===i.INT&&(ee=i.RGBA32I)),x===i.RGB&&(L===i.UNSIGNED_INT_5_9_9_9_REV&&(ee=i.RGB9_E5),L===i.UNSIGNED_INT_10F_11F_11F_REV&&(ee=i.R11F_G11F_B10F)),x===i.RGBA){let Pe=ne?Ro:ut.getTransfer(K);L===i.FLOAT&&(ee=i.RGBA32F),L===i.HALF_FLOAT&&(ee=i.RGBA16F),L===i.UNSIGNED_BYTE&&(ee=Pe===St?i.SRGB8_ALPHA8:i.RGBA8),L===i.UNSIGNED_SHORT_4_4_4_4&&(ee=i.RGBA4),L===i.UNSIGNED_SHORT_5_5_5_1&&(ee=i.RGB5_A1)}return(ee===i.R16F||ee===i.R32F||ee===i.RG16F||ee===i.RG32F||ee===i.RGBA16F||ee===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ee}function w(I,x){let L;return I?x===null||x===gi||x===Zr?L=i.DEPTH24_STENCIL8:x===Zn?L=i.DEPTH32F_STENCIL8:x===$r&&(L=i.DEPTH24_STENCIL8,qe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===gi||x===Zr?L=i.DEPTH_COMPONENT24:x===Zn?L=i.DEPTH_COMPONENT32F:x===$r&&(L=i.DEPTH_COMPONENT16),L}function D(I,x){return p(I)===!0||I.isFramebufferTexture&&I.minFilter!==Qt&&I.minFilter!==gn?Math.log2(Math.max(x.width,x.height))+1:I.mipmaps!==void 0&&I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?x.mipmaps.length:1}function R(I){let x=I.target;x.removeEventListener("dispose",R),v(x),x.isVideoTexture&&h.delete(x)}function N(I){let x=I.target;x.removeEventListener("dispose",N),q(x)}function v(I){let x=n.get(I);if(x.__webglInit===void 0)return;let L=I.source,K=u.get(L);if(K){let ne=K[x.__cacheKey];ne.usedTimes--,ne.usedTimes===0&&T(I),Object.keys(K).length===0&&u.delete(L)}n.remove(I)}function T(I){let x=n.get(I);i.deleteTexture(x.__webglTexture);let L=I.source,K=u.get(L);delete K[x.__cacheKey],o.memory.textures--}function q(I){let x=n.get(I);if(I.depthTexture&&(I.depthTexture.dispose(),n.remove(I.depthTexture)),I.isWebGLCubeRenderTarget)for(let K=0;K<6;K++){if(Array.isArray(x.__webglFramebuffer[K]))for(let ne=0;ne<x.__webglFramebuffer[K].length;ne++)i.deleteFramebuffer(x.__webglFramebuffer[K][ne]);else i.deleteFramebuffer(x.__webglFramebuffer[K]);x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer[K])}else{if(Array.isArray(x.__webglFramebuffer))for(let K=0;K<x.__webglFramebuffer.length;K++)i.deleteFramebuffer(x.__webglFramebuffer[K]);else i.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&i.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let K=0;K<x.__webglColorRenderbuffer.length;K++)x.__webglColorRenderbuffer[K]&&i.deleteRenderbuffer(x.__webglColorRenderbuffer[K]);x.__webglDepthRenderbuffer&&i.deleteRenderbuffer(x.__webglDepthRenderbuffer)}let L=I.textures;for(let K=0,ne=L.length;K<ne;K++){let ee=n.get(L[K]);ee.__webglTexture&&(i.deleteTexture(ee.__webglTexture),o.memory.textures--),n.remove(L[K])}n.remove(I)}let E=0;function G(){E=0}function O(){let I=E;return I>=s.maxTextures&&qe("WebGLTextures: Trying to use "+I+" texture units while this GPU supports only "+s.maxTextures),E+=1,I}function W(I){let x=[];return x.push(I.wrapS),x.push(I.wrapT),x.push(I.wrapR||0),x.push(I.magFilter),x.push(I.minFilter),x.push(I.anisotropy),x.push(I.internalFormat),x.push(I.format),x.push(I.type),x.push(I.generateMipmaps),x.push(I.premultiplyAlpha),x.push(I.flipY),x.push(I.unpackAlignment),x.push(I.colorSpace),x.join()}function V(I,x){let L=n.get(I);if(I.isVideoTexture&&Ze(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&L.__version!==I.version){let K=I.image;if(K===null)qe("WebGLRenderer: Texture marked for update but no image data found.");else if(K.complete===!1)qe("WebGLRenderer: Texture marked for update but image is incomplete");else{Q(L,I,x);return}}else I.isExternalTexture&&(L.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,L.__webglTexture,i.TEXTURE0+x)}function H(I,x){let L=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&L.__version!==I.version){Q(L,I,x);return}else I.isExternalTexture&&(L.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,L.__webglTexture,i.TEXTURE0+x)}function U(I,x){let L=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&L.__version!==I.version){Q(L,I,x);return}t.bindTexture(i.TEXTURE_3D,L.__webglTexture,i.TEXTURE0+x)}function le(I,x){let L=n.get(I);if(I.isCubeDepthTexture!==!0&&I.version>0&&L.__version!==I.version){re(L,I,x);return}t.bindTexture(i.TEXTURE_CUBE_MAP,L.__webglTexture,i.TEXTURE0+x)}let ie={[hl]:i.REPEAT,[Ni]:i.CLAMP_TO_EDGE,[ul]:i.MIRRORED_REPEAT},ce={[Qt]:i.NEAREST,[Bd]:i.NEAREST_MIPMAP_NEAREST,[Zo]:i.NEAREST_MIPMAP_LINEAR,[gn]:i.LINEAR,[Fl]:i.LINEAR_MIPMAP_NEAREST,[Is]:i.LINEAR_MIPMAP_LINEAR},_e={[Gd]:i.NEVER,[Yd]:i.ALWAYS,[Hd]:i.LESS,[vc]:i.LEQUAL,[Wd]:i.EQUAL,[yc]:i.GEQUAL,[Xd]:i.GREATER,[qd]:i.NOTEQUAL};function oe(I,x){if(x.type===Zn&&e.has("OES_texture_float_linear")===!1&&(x.magFilter===gn||x.magFilter===Fl||x.magFilter===Zo||x.magFilter===Is||x.minFilter===gn||x.minFilter===Fl||x.minFilter===Zo||x.minFilter===Is)&&qe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,ie[x.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,ie[x.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,ie[x.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,ce[x.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,ce[x.minFilter]),x.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,_e[x.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===Qt||x.minFilter!==Zo&&x.minFilter!==Is||x.type===Zn&&e.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||n.get(x).__currentAnisotropy){let L=e.get("EXT_texture_filter_anisotropic");i.texParameterf(I,L.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(x.anisotropy,s.getMaxAnisotropy())),n.get(x).__currentAnisotropy=x.anisotropy}}}function ue(I,x){let L=!1;I.__webglInit===void 0&&(I.__webglInit=!0,x.addEventListener("dispose",R));let K=x.source,ne=u.get(K);ne===void 0&&(ne={},u.set(K,ne));let ee=W(x);if(ee!==I.__cacheKey){ne[ee]===void 0&&(ne[ee]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,L=!0),ne[ee].usedTimes++;let Pe=ne[I.__cacheKey];Pe!==void 0&&(ne[I.__cacheKey].usedTimes--,Pe.usedTimes===0&&T(x)),I.__cacheKey=ee,I.__webglTexture=ne[ee].texture}return L}function et(I,x,L){return Math.floor(Math.floor(I/L)/x)}function it(I,x,L,K){let ee=I.updateRanges;if(ee.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,x.width,x.height,L,K,x.data);else{ee.sort((ae,he)=>ae.start-he.start);let Pe=0;for(let ae=1;ae<ee.length;ae++){let he=ee[Pe],we=ee[ae],Ne=he.start+he.count,Ae=et(we.start,x.width,4),Je=et(he.start,x.width,4);we.start<=Ne+1&&Ae===Je&&et(we.start+we.count-1,x.width,4)===Ae?he.count=Math.max(he.count,we.start+we.count-he.start):(++Pe,ee[Pe]=we)}ee.length=Pe+1;let ge=i.getParameter(i.UNPACK_ROW_LENGTH),Oe=i.getParameter(i.UNPACK_SKIP_PIXELS),Be=i.getParameter(i.UNPACK_SKIP_ROWS);i.pixelStorei(i.UNPACK_ROW_LENGTH,x.width);for(let ae=0,he=ee.length;ae<he;ae++){let we=ee[ae],Ne=Math.floor(we.start/4),Ae=Math.ceil(we.count/4),Je=Ne%x.width,B=Math.floor(Ne/x.width),ve=Ae,fe=1;i.pixelStorei(i.UNPACK_SKIP_PIXELS,Je),i.pixelStorei(i.UNPACK_SKIP_ROWS,B),t.texSubImage2D(i.TEXTURE_2D,0,Je,B,ve,fe,L,K,x.data)}I.clearUpdateRanges(),i.pixelStorei(i.UNPACK_ROW_LENGTH,ge),i.pixelStorei(i.UNPACK_SKIP_PIXELS,Oe),i.pixelStorei(i.UNPACK_SKIP_ROWS,Be)}}function Q(I,x,L){let K=i.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(K=i.TEXTURE_2D_ARRAY),x.isData3DTexture&&(K=i.TEXTURE_3D);let ne=ue(I,x),ee=x.source;t.bindTexture(K,I.__webglTexture,i.TEXTURE0+L);let Pe=n.get(ee);if(ee.version!==Pe.__version||ne===!0){t.activeTexture(i.TEXTURE0+L);let ge=ut.getPrimaries(ut.workingColorSpace),Oe=x.colorSpace===ts?null:ut.getPrimaries(x.colorSpace),Be=x.colorSpace===ts||ge===Oe?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Be);let ae=M(x.image,!1,s.maxTextureSize);ae=dt(x,ae);let he=r.convert(x.format,x.colorSpace),we=r.convert(x.type),Ne=A(x.internalFormat,he,we,x.colorSpace,x.isVideoTexture);oe(K,x);let Ae,Je=x.mipmaps,B=x.isVideoTexture!==!0,ve=Pe.__version===void 0||ne===!0,fe=ee.dataReady,Le=D(x,ae);if(x.isDepthTexture)Ne=w(x.format===Ps,x.type),ve&&(B?t.texStorage2D(i.TEXTURE_2D,1,Ne,ae.width,ae.height):t.texImage2D(i.TEXTURE_2D,0,Ne,ae.width,ae.height,0,he,we,null));else if(x.isDataTexture)if(Je.length>0){B&&ve&&t.texStorage2D(i.TEXTURE_2D,Le,Ne,Je[0].width,Je[0].height);for(let pe=0,te=Je.length;pe<te;pe++)Ae=Je[pe],B?fe&&t.texSubImage2D(i.TEXTURE_2D,pe,0,0,Ae.width,Ae.height,he,we,Ae.data):t.texImage2D(i.TEXTURE_2D,pe,Ne,Ae.width,Ae.height,0,he,we,Ae.data);x.generateMipmaps=!1}else B?(ve&&t.texStorage2D(i.TEXTURE_2D,Le,Ne,ae.width,ae.height),fe&&it(x,ae,he,we)):t.texImage2D(i.TEXTURE_2D,0,Ne,ae.width,ae.height,0,he,we,ae.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){B&&ve&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Le,Ne,Je[0].width,Je[0].height,ae.depth);for(let pe=0,te=Je.length;pe<te;pe++)if(Ae=Je[pe],x.format!==Pn)if(he!==null)if(B){if(fe)if(x.layerUpdates.size>0){let Ue=_u(Ae.width,Ae.height,x.format,x.type);for(let Ke of x.layerUpdates){let Et=Ae.data.subarray(Ke*Ue/Ae.data.BYTES_PER_ELEMENT,(Ke+1)*Ue/Ae.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,pe,0,0,Ke,Ae.width,Ae.height,1,he,Et)}x.clearLayerUpdates()}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,pe,0,0,0,Ae.width,Ae.height,ae.depth,he,Ae.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,pe,Ne,Ae.width,Ae.height,ae.depth,0,Ae.data,0,0);else qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else B?fe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,pe,0,0,0,Ae.width,Ae.height,ae.depth,he,we,Ae.data):t.texImage3D(i.TEXTURE_2D_ARRAY,pe,Ne,Ae.width,Ae.height,ae.depth,0,he,we,Ae.data)}else{B&&ve&&t.texStorage2D(i.TEXTURE_2D,Le,Ne,Je[0].width,Je[0].height);for(let pe=0,te=Je.length;pe<te;pe++)Ae=Je[pe],x.format!==Pn?he!==null?B?fe&&t.compressedTexSubImage2D(i.TEXTURE_2D,pe,0,0,Ae.width,Ae.height,he,Ae.data):t.compressedTexImage2D(i.TEXTURE_2D,pe,Ne,Ae.width,Ae.height,0,Ae.data):qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):B?fe&&t.texSubImage2D(i.TEXTURE_2D,pe,0,0,Ae.width,Ae.height,he,we,Ae.data):t.texImage2D(i.TEXTURE_2D,pe,Ne,Ae.width,Ae.height,0,he,we,Ae.data)}else if(x.isDataArrayTexture)if(B){if(ve&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Le,Ne,ae.width,ae.height,ae.depth),fe)if(x.layerUpdates.size>0){let pe=_u(ae.width,ae.height,x.format,x.type);for(let te of x.layerUpdates){let Ue=ae.data.subarray(te*pe/ae.data.BYTES_PER_ELEMENT,(te+1)*pe/ae.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,te,ae.width,ae.height,1,he,we,Ue)}x.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ae.width,ae.height,ae.depth,he,we,ae.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,Ne,ae.width,ae.height,ae.depth,0,he,we,ae.data);else if(x.isData3DTexture)B?(ve&&t.texStorage3D(i.TEXTURE_3D,Le,Ne,ae.width,ae.height,ae.depth),fe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ae.width,ae.height,ae.depth,he,we,ae.data)):t.texImage3D(i.TEXTURE_3D,0,Ne,ae.width,ae.height,ae.depth,0,he,we,ae.data);else if(x.isFramebufferTexture){if(ve)if(B)t.texStorage2D(i.TEXTURE_2D,Le,Ne,ae.width,ae.height);else{let pe=ae.width,te=ae.height;for(let Ue=0;Ue<Le;Ue++)t.texImage2D(i.TEXTURE_2D,Ue,Ne,pe,te,0,he,we,null),pe>>=1,te>>=1}}else if(Je.length>0){if(B&&ve){let pe=Ie(Je[0]);t.texStorage2D(i.TEXTURE_2D,Le,Ne,pe.width,pe.height)}for(let pe=0,te=Je.length;pe<te;pe++)Ae=Je[pe],B?fe&&t.texSubImage2D(i.TEXTURE_2D,pe,0,0,he,we,Ae):t.texImage2D(i.TEXTURE_2D,pe,Ne,he,we,Ae);x.generateMipmaps=!1}else if(B){if(ve){let pe=Ie(ae);t.texStorage2D(i.TEXTURE_2D,Le,Ne,pe.width,pe.height)}fe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,he,we,ae)}else t.texImage2D(i.TEXTURE_2D,0,Ne,he,we,ae);p(x)&&m(K),Pe.__version=ee.version,x.onUpdate&&x.onUpdate(x)}I.__version=x.version}function re(I,x,L){if(x.image.length!==6)return;let K=ue(I,x),ne=x.source;t.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+L);let ee=n.get(ne);if(ne.version!==ee.__version||K===!0){t.activeTexture(i.TEXTURE0+L);let Pe=ut.getPrimaries(ut.workingColorSpace),ge=x.colorSpace===ts?null:ut.getPrimaries(x.colorSpace),Oe=x.colorSpace===ts||Pe===ge?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Oe);let Be=x.isCompressedTexture||x.image[0].isCompressedTexture,ae=x.image[0]&&x.image[0].isDataTexture,he=[];for(let te=0;te<6;te++)!Be&&!ae?he[te]=M(x.image[te],!0,s.maxCubemapSize):he[te]=ae?x.image[te].image:x.image[te],he[te]=dt(x,he[te]);let we=he[0],Ne=r.convert(x.format,x.colorSpace),Ae=r.convert(x.type),Je=A(x.internalFormat,Ne,Ae,x.colorSpace),B=x.isVideoTexture!==!0,ve=ee.__version===void 0||K===!0,fe=ne.dataReady,Le=D(x,we);oe(i.TEXTURE_CUBE_MAP,x);let pe;if(Be){B&&ve&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Le,Je,we.width,we.height);for(let te=0;te<6;te++){pe=he[te].mipmaps;for(let Ue=0;Ue<pe.length;Ue++){let Ke=pe[Ue];x.format!==Pn?Ne!==null?B?fe&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+te,Ue,0,0,Ke.width,Ke.height,Ne,Ke.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+te,Ue,Je,Ke.width,Ke.height,0,Ke.data):qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):B?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+te,Ue,0,0,Ke.width,Ke.height,Ne,Ae,Ke.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+te,Ue,Je,Ke.width,Ke.height,0,Ne,Ae,Ke.data)}}}else{if(pe=x.mipmaps,B&&ve){pe.length>0&&Le++;let te=Ie(he[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Le,Je,te.width,te.height)}for(let te=0;te<6;te++)if(ae){B?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0,0,0,he[te].width,he[te].height,Ne,Ae,he[te].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0,Je,he[te].width,he[te].height,0,Ne,Ae,he[te].data);for(let Ue=0;Ue<pe.length;Ue++){let Et=pe[Ue].image[te].image;B?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+te,Ue+1,0,0,Et.width,Et.height,Ne,Ae,Et.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+te,Ue+1,Je,Et.width,Et.height,0,Ne,Ae,Et.data)}}else{B?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0,0,0,Ne,Ae,he[te]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0,Je,Ne,Ae,he[te]);for(let Ue=0;Ue<pe.length;Ue++){let Ke=pe[Ue];B?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+te,Ue+1,0,0,Ne,Ae,Ke.image[te]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+te,Ue+1,Je,Ne,Ae,Ke.image[te])}}}p(x)&&m(i.TEXTURE_CUBE_MAP),ee.__version=ne.version,x.onUpdate&&x.onUpdate(x)}I.__version=x.version}function me(I,x,L,K,ne,ee){let Pe=r.convert(L.format,L.colorSpace),ge=r.convert(L.type),Oe=A(L.internalFormat,Pe,ge,L.colorSpace),Be=n.get(x),ae=n.get(L);if(ae.__renderTarget=x,!Be.__hasExternalTextures){let he=Math.max(1,x.width>>ee),we=Math.max(1,x.height>>ee);ne===i.TEXTURE_3D||ne===i.TEXTURE_2D_ARRAY?t.texImage3D(ne,ee,Oe,he,we,x.depth,0,Pe,ge,null):t.texImage2D(ne,ee,Oe,he,we,0,Pe,ge,null)}t.bindFramebuffer(i.FRAMEBUFFER,I),Tt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,K,ne,ae.__webglTexture,0,F(x)):(ne===i.TEXTURE_2D||ne>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ne<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,K,ne,ae.__webglTexture,ee),t.bindFramebuffer(i.FRAMEBUFFER,null)}function He(I,x,L){if(i.bindRenderbuffer(i.RENDERBUFFER,I),x.depthBuffer){let K=x.depthTexture,ne=K&&K.isDepthTexture?K.type:null,ee=w(x.stencilBuffer,ne),Pe=x.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Tt(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,F(x),ee,x.width,x.height):L?i.renderbufferStorageMultisample(i.RENDERBUFFER,F(x),ee,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,ee,x.width,x.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Pe,i.RENDERBUFFER,I)}else{let K=x.textures;for(let ne=0;ne<K.length;ne++){let ee=K[ne],Pe=r.convert(ee.format,ee.colorSpace),ge=r.convert(ee.type),Oe=A(ee.internalFormat,Pe,ge,ee.colorSpace);Tt(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,F(x),Oe,x.width,x.height):L?i.renderbufferStorageMultisample(i.RENDERBUFFER,F(x),Oe,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,Oe,x.width,x.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Se(I,x,L){let K=x.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,I),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let ne=n.get(x.depthTexture);if(ne.__renderTarget=x,(!ne.__webglTexture||x.depthTexture.image.width!==x.width||x.depthTexture.image.height!==x.height)&&(x.depthTexture.image.width=x.width,x.depthTexture.image.height=x.height,x.depthTexture.needsUpdate=!0),K){if(ne.__webglInit===void 0&&(ne.__webglInit=!0,x.depthTexture.addEventListener("dispose",R)),ne.__webglTexture===void 0){ne.__webglTexture=i.createTexture(),t.bindTexture(i.TEXTURE_CUBE_MAP,ne.__webglTexture),oe(i.TEXTURE_CUBE_MAP,x.depthTexture);let Be=r.convert(x.depthTexture.format),ae=r.convert(x.depthTexture.type),he;x.depthTexture.format===Fi?he=i.DEPTH_COMPONENT24:x.depthTexture.format===Ps&&(he=i.DEPTH24_STENCIL8);for(let we=0;we<6;we++)i.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,0,he,x.width,x.height,0,Be,ae,null)}}else V(x.depthTexture,0);let ee=ne.__webglTexture,Pe=F(x),ge=K?i.TEXTURE_CUBE_MAP_POSITIVE_X+L:i.TEXTURE_2D,Oe=x.depthTexture.format===Ps?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(x.depthTexture.format===Fi)Tt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Oe,ge,ee,0,Pe):i.framebufferTexture2D(i.FRAMEBUFFER,Oe,ge,ee,0);else if(x.depthTexture.format===Ps)Tt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Oe,ge,ee,0,Pe):i.framebufferTexture2D(i.FRAMEBUFFER,Oe,ge,ee,0);else throw new Error("Unknown depthTexture format")}function Ge(I){let x=n.get(I),L=I.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==I.depthTexture){let K=I.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),K){let ne=()=>{delete x.__boundDepthTexture,delete x.__depthDisposeCallback,K.removeEventListener("dispose",ne)};K.addEventListener("dispose",ne),x.__depthDisposeCallback=ne}x.__boundDepthTexture=K}if(I.depthTexture&&!x.__autoAllocateDepthBuffer)if(L)for(let K=0;K<6;K++)Se(x.__webglFramebuffer[K],I,K);else{let K=I.texture.mipmaps;K&&K.length>0?Se(x.__webglFramebuffer[0],I,0):Se(x.__webglFramebuffer,I,0)}else if(L){x.__webglDepthbuffer=[];for(let K=0;K<6;K++)if(t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[K]),x.__webglDepthbuffer[K]===void 0)x.__webglDepthbuffer[K]=i.createRenderbuffer(),He(x.__webglDepthbuffer[K],I,!1);else{let ne=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ee=x.__webglDepthbuffer[K];i.bindRenderbuffer(i.RENDERBUFFER,ee),i.framebufferRenderbuffer(i.FRAMEBUFFER,ne,i.RENDERBUFFER,ee)}}else{let K=I.texture.mipmaps;if(K&&K.length>0?t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=i.createRenderbuffer(),He(x.__webglDepthbuffer,I,!1);else{let ne=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ee=x.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ee),i.framebufferRenderbuffer(i.FRAMEBUFFER,ne,i.RENDERBUFFER,ee)}}t.bindFramebuffer(i.FRAMEBUFFER,null)}function At(I,x,L){let K=n.get(I);x!==void 0&&me(K.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),L!==void 0&&Ge(I)}function Ye(I){let x=I.texture,L=n.get(I),K=n.get(x);I.addEventListener("dispose",N);let ne=I.textures,ee=I.isWebGLCubeRenderTarget===!0,Pe=ne.length>1;if(Pe||(K.__webglTexture===void 0&&(K.__webglTexture=i.createTexture()),K.__version=x.version,o.memory.textures++),ee){L.__webglFramebuffer=[];for(let ge=0;ge<6;ge++)if(x.mipmaps&&x.mipmaps.length>0){L.__webglFramebuffer[ge]=[];for(let Oe=0;Oe<x.mipmaps.length;Oe++)L.__webglFramebuffer[ge][Oe]=i.createFramebuffer()}else L.__webglFramebuffer[ge]=i.createFramebuffer()}else{if(x.mipmaps&&x.mipmaps.length>0){L.__webglFramebuffer=[];for(let ge=0;ge<x.mipmaps.length;ge++)L.__webglFramebuffer[ge]=i.createFramebuffer()}else L.__webglFramebuffer=i.createFramebuffer();if(Pe)for(let ge=0,Oe=ne.length;ge<Oe;ge++){let Be=n.get(ne[ge]);Be.__webglTexture===void 0&&(Be.__webglTexture=i.createTexture(),o.memory.textures++)}if(I.samples>0&&Tt(I)===!1){L.__webglMultisampledFramebuffer=i.createFramebuffer(),L.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,L.__webglMultisampledFramebuffer);for(let ge=0;ge<ne.length;ge++){let Oe=ne[ge];L.__webglColorRenderbuffer[ge]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,L.__webglColorRenderbuffer[ge]);let Be=r.convert(Oe.format,Oe.colorSpace),ae=r.convert(Oe.type),he=A(Oe.internalFormat,Be,ae,Oe.colorSpace,I.isXRRenderTarget===!0),we=F(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,we,he,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ge,i.RENDERBUFFER,L.__webglColorRenderbuffer[ge])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&(L.__webglDepthRenderbuffer=i.createRenderbuffer(),He(L.__webglDepthRenderbuffer,I,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ee){t.bindTexture(i.TEXTURE_CUBE_MAP,K.__webglTexture),oe(i.TEXTURE_CUBE_MAP,x);for(let ge=0;ge<6;ge++)if(x.mipmaps&&x.mipmaps.length>0)for(let Oe=0;Oe<x.mipmaps.length;Oe++)me(L.__webglFramebuffer[ge][Oe],I,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,Oe);else me(L.__webglFramebuffer[ge],I,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0);p(x)&&m(i.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(Pe){for(let ge=0,Oe=ne.length;ge<Oe;ge++){let Be=ne[ge],ae=n.get(Be),he=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(he=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(he,ae.__webglTexture),oe(he,Be),me(L.__webglFramebuffer,I,Be,i.COLOR_ATTACHMENT0+ge,he,0),p(Be)&&m(he)}t.unbindTexture()}else{let ge=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ge=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ge,K.__webglTexture),oe(ge,x),x.mipmaps&&x.mipmaps.length>0)for(let Oe=0;Oe<x.mipmaps.length;Oe++)me(L.__webglFramebuffer[Oe],I,x,i.COLOR_ATTACHMENT0,ge,Oe);else me(L.__webglFramebuffer,I,x,i.COLOR_ATTACHMENT0,ge,0);p(x)&&m(ge),t.unbindTexture()}I.depthBuffer&&Ge(I)}function rt(I){let x=I.textures;for(let L=0,K=x.length;L<K;L++){let ne=x[L];if(p(ne)){let ee=y(I),Pe=n.get(ne).__webglTexture;t.bindTexture(ee,Pe),m(ee),t.unbindTexture()}}}let ht=[],$e=[];function Rt(I){if(I.samples>0){if(Tt(I)===!1){let x=I.textures,L=I.width,K=I.height,ne=i.COLOR_BUFFER_BIT,ee=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Pe=n.get(I),ge=x.length>1;if(ge)for(let Be=0;Be<x.length;Be++)t.bindFramebuffer(i.FRAMEBUFFER,Pe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Be,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Pe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Be,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Pe.__webglMultisampledFramebuffer);let Oe=I.texture.mipmaps;Oe&&Oe.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Pe.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Pe.__webglFramebuffer);for(let Be=0;Be<x.length;Be++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(ne|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(ne|=i.STENCIL_BUFFER_BIT)),ge){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Pe.__webglColorRenderbuffer[Be]);let ae=n.get(x[Be]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,ae,0)}i.blitFramebuffer(0,0,L,K,0,0,L,K,ne,i.NEAREST),l===!0&&(ht.length=0,$e.length=0,ht.push(i.COLOR_ATTACHMENT0+Be),I.depthBuffer&&I.resolveDepthBuffer===!1&&(ht.push(ee),$e.push(ee),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,$e)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,ht))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ge)for(let Be=0;Be<x.length;Be++){t.bindFramebuffer(i.FRAMEBUFFER,Pe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Be,i.RENDERBUFFER,Pe.__webglColorRenderbuffer[Be]);let ae=n.get(x[Be]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Pe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Be,i.TEXTURE_2D,ae,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Pe.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.resolveDepthBuffer===!1&&l){let x=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[x])}}}function F(I){return Math.min(s.maxSamples,I.samples)}function Tt(I){let x=n.get(I);return I.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function Ze(I){let x=o.render.frame;h.get(I)!==x&&(h.set(I,x),I.update())}function dt(I,x){let L=I.colorSpace,K=I.format,ne=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||L!==Zs&&L!==ts&&(ut.getTransfer(L)===St?(K!==Pn||ne!==bn)&&qe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Xe("WebGLTextures: Unsupported texture color space:",L)),x}function Ie(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=O,this.resetTextureUnits=G,this.setTexture2D=V,this.setTexture2DArray=H,this.setTexture3D=U,this.setTextureCube=le,this.rebindTextures=At,this.setupRenderTarget=Ye,this.updateRenderTargetMipmap=rt,this.updateMultisampleRenderTarget=Rt,this.setupDepthRenderbuffer=Ge,this.setupFrameBufferTexture=me,this.useMultisampledRTT=Tt,this.isReversedDepthBuffer=function(){return t.buffers.depth.getReversed()}}function EM(i,e){function t(n,s=ts){let r,o=ut.getTransfer(s);if(n===bn)return i.UNSIGNED_BYTE;if(n===Ol)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Bl)return i.UNSIGNED_SHORT_5_5_5_1;if(n===lu)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===cu)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===ou)return i.BYTE;if(n===au)return i.SHORT;if(n===$r)return i.UNSIGNED_SHORT;if(n===Ul)return i.INT;if(n===gi)return i.UNSIGNED_INT;if(n===Zn)return i.FLOAT;if(n===zi)return i.HALF_FLOAT;if(n===hu)return i.ALPHA;if(n===uu)return i.RGB;if(n===Pn)return i.RGBA;if(n===Fi)return i.DEPTH_COMPONENT;if(n===Ps)return i.DEPTH_STENCIL;if(n===fu)return i.RED;if(n===kl)return i.RED_INTEGER;if(n===js)return i.RG;if(n===zl)return i.RG_INTEGER;if(n===Jr)return i.RGBA_INTEGER;if(n===Jo||n===Ko||n===jo||n===Qo)if(o===St)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Jo)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ko)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===jo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Qo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Jo)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ko)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===jo)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Qo)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Vl||n===Gl||n===Hl||n===Wl)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Vl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Gl)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Hl)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Wl)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Xl||n===ql||n===Yl||n===$l||n===Zl||n===Jl||n===Kl)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Xl||n===ql)return o===St?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Yl)return o===St?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===$l)return r.COMPRESSED_R11_EAC;if(n===Zl)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Jl)return r.COMPRESSED_RG11_EAC;if(n===Kl)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===jl||n===Ql||n===ec||n===tc||n===nc||n===ic||n===sc||n===rc||n===oc||n===ac||n===lc||n===cc||n===hc||n===uc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===jl)return o===St?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Ql)return o===St?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===ec)return o===St?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===tc)return o===St?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===nc)return o===St?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===ic)return o===St?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===sc)return o===St?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===rc)return o===St?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===oc)return o===St?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===ac)return o===St?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===lc)return o===St?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===cc)return o===St?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===hc)return o===St?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===uc)return o===St?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===fc||n===dc||n===pc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===fc)return o===St?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===dc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===pc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===mc||n===gc||n===_c||n===xc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===mc)return r.COMPRESSED_RED_RGTC1_EXT;if(n===gc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===_c)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===xc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Zr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var CM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,RM=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Pu=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Ho(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Yn({vertexShader:CM,fragmentShader:RM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Mn(new Wo(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Lu=class extends Qi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,f=null,u=null,d=null,g=null,M=typeof XRWebGLBinding<"u",p=new Pu,m={},y=t.getContextAttributes(),A=null,w=null,D=[],R=[],N=new Mt,v=null,T=new Un;T.viewport=new Yt;let q=new Un;q.viewport=new Yt;let E=[T,q],G=new Ll,O=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let re=D[Q];return re===void 0&&(re=new Gr,D[Q]=re),re.getTargetRaySpace()},this.getControllerGrip=function(Q){let re=D[Q];return re===void 0&&(re=new Gr,D[Q]=re),re.getGripSpace()},this.getHand=function(Q){let re=D[Q];return re===void 0&&(re=new Gr,D[Q]=re),re.getHandSpace()};function V(Q){let re=R.indexOf(Q.inputSource);if(re===-1)return;let me=D[re];me!==void 0&&(me.update(Q.inputSource,Q.frame,c||o),me.dispatchEvent({type:Q.type,data:Q.inputSource}))}function H(){s.removeEventListener("select",V),s.removeEventListener("selectstart",V),s.removeEventListener("selectend",V),s.removeEventListener("squeeze",V),s.removeEventListener("squeezestart",V),s.removeEventListener("squeezeend",V),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",U);for(let Q=0;Q<D.length;Q++){let re=R[Q];re!==null&&(R[Q]=null,D[Q].disconnect(re))}O=null,W=null,p.reset();for(let Q in m)delete m[Q];e.setRenderTarget(A),d=null,u=null,f=null,s=null,w=null,it.stop(),n.isPresenting=!1,e.setPixelRatio(v),e.setSize(N.width,N.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&qe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&qe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return u!==null?u:d},this.getBinding=function(){return f===null&&M&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",V),s.addEventListener("selectstart",V),s.addEventListener("selectend",V),s.addEventListener("squeeze",V),s.addEventListener("squeezestart",V),s.addEventListener("squeezeend",V),s.addEventListener("end",H),s.addEventListener("inputsourceschange",U),y.xrCompatible!==!0&&await t.makeXRCompatible(),v=e.getPixelRatio(),e.getSize(N),M&&"createProjectionLayer"in XRWebGLBinding.prototype){let me=null,He=null,Se=null;y.depth&&(Se=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,me=y.stencil?Ps:Fi,He=y.stencil?Zr:gi);let Ge={colorFormat:t.RGBA8,depthFormat:Se,scaleFactor:r};f=this.getBinding(),u=f.createProjectionLayer(Ge),s.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),w=new Rn(u.textureWidth,u.textureHeight,{format:Pn,type:bn,depthTexture:new As(u.textureWidth,u.textureHeight,He,void 0,void 0,void 0,void 0,void 0,void 0,me),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1})}else{let me={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,me),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),w=new Rn(d.framebufferWidth,d.framebufferHeight,{format:Pn,type:bn,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}w.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),it.setContext(s),it.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function U(Q){for(let re=0;re<Q.removed.length;re++){let me=Q.removed[re],He=R.indexOf(me);He>=0&&(R[He]=null,D[He].disconnect(me))}for(let re=0;re<Q.added.length;re++){let me=Q.added[re],He=R.indexOf(me);if(He===-1){for(let Ge=0;Ge<D.length;Ge++)if(Ge>=R.length){R.push(me),He=Ge;break}else if(R[Ge]===null){R[Ge]=me,He=Ge;break}if(He===-1)break}let Se=D[He];Se&&Se.connect(me)}}let le=new Z,ie=new Z;function ce(Q,re,me){le.setFromMatrixPosition(re.matrixWorld),ie.setFromMatrixPosition(me.matrixWorld);let He=le.distanceTo(ie),Se=re.projectionMatrix.elements,Ge=me.projectionMatrix.elements,At=Se[14]/(Se[10]-1),Ye=Se[14]/(Se[10]+1),rt=(Se[9]+1)/Se[5],ht=(Se[9]-1)/Se[5],$e=(Se[8]-1)/Se[0],Rt=(Ge[8]+1)/Ge[0],F=At*$e,Tt=At*Rt,Ze=He/(-$e+Rt),dt=Ze*-$e;if(re.matrixWorld.decompose(Q.position,Q.quaternion,Q.scale),Q.translateX(dt),Q.translateZ(Ze),Q.matrixWorld.compose(Q.position,Q.quaternion,Q.scale),Q.matrixWorldInverse.copy(Q.matrixWorld).invert(),Se[10]===-1)Q.projectionMatrix.copy(re.projectionMatrix),Q.projectionMatrixInverse.copy(re.projectionMatrixInverse);else{let Ie=At+Ze,I=Ye+Ze,x=F-dt,L=Tt+(He-dt),K=rt*Ye/I*Ie,ne=ht*Ye/I*Ie;Q.projectionMatrix.makePerspective(x,L,K,ne,Ie,I),Q.projectionMatrixInverse.copy(Q.projectionMatrix).invert()}}function _e(Q,re){re===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(re.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let re=Q.near,me=Q.far;p.texture!==null&&(p.depthNear>0&&(re=p.depthNear),p.depthFar>0&&(me=p.depthFar)),G.near=q.near=T.near=re,G.far=q.far=T.far=me,(O!==G.near||W!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),O=G.near,W=G.far),G.layers.mask=Q.layers.mask|6,T.layers.mask=G.layers.mask&-5,q.layers.mask=G.layers.mask&-3;let He=Q.parent,Se=G.cameras;_e(G,He);for(let Ge=0;Ge<Se.length;Ge++)_e(Se[Ge],He);Se.length===2?ce(G,T,q):G.projectionMatrix.copy(T.projectionMatrix),oe(Q,G,He)};function oe(Q,re,me){me===null?Q.matrix.copy(re.matrixWorld):(Q.matrix.copy(me.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(re.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(re.projectionMatrix),Q.projectionMatrixInverse.copy(re.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=dl*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(u===null&&d===null))return l},this.setFoveation=function(Q){l=Q,u!==null&&(u.fixedFoveation=Q),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=Q)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(G)},this.getCameraTexture=function(Q){return m[Q]};let ue=null;function et(Q,re){if(h=re.getViewerPose(c||o),g=re,h!==null){let me=h.views;d!==null&&(e.setRenderTargetFramebuffer(w,d.framebuffer),e.setRenderTarget(w));let He=!1;me.length!==G.cameras.length&&(G.cameras.length=0,He=!0);for(let Ye=0;Ye<me.length;Ye++){let rt=me[Ye],ht=null;if(d!==null)ht=d.getViewport(rt);else{let Rt=f.getViewSubImage(u,rt);ht=Rt.viewport,Ye===0&&(e.setRenderTargetTextures(w,Rt.colorTexture,Rt.depthStencilTexture),e.setRenderTarget(w))}let $e=E[Ye];$e===void 0&&($e=new Un,$e.layers.enable(Ye),$e.viewport=new Yt,E[Ye]=$e),$e.matrix.fromArray(rt.transform.matrix),$e.matrix.decompose($e.position,$e.quaternion,$e.scale),$e.projectionMatrix.fromArray(rt.projectionMatrix),$e.projectionMatrixInverse.copy($e.projectionMatrix).invert(),$e.viewport.set(ht.x,ht.y,ht.width,ht.height),Ye===0&&(G.matrix.copy($e.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),He===!0&&G.cameras.push($e)}let Se=s.enabledFeatures;if(Se&&Se.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&M){f=n.getBinding();let Ye=f.getDepthInformation(me[0]);Ye&&Ye.isValid&&Ye.texture&&p.init(Ye,s.renderState)}if(Se&&Se.includes("camera-access")&&M){e.state.unbindTexture(),f=n.getBinding();for(let Ye=0;Ye<me.length;Ye++){let rt=me[Ye].camera;if(rt){let ht=m[rt];ht||(ht=new Ho,m[rt]=ht);let $e=f.getCameraImage(rt);ht.sourceTexture=$e}}}}for(let me=0;me<D.length;me++){let He=R[me],Se=D[me];He!==null&&Se!==void 0&&Se.update(He,re,c||o)}ue&&ue(Q,re),re.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:re}),g=null}let it=new Sp;it.setAnimationLoop(et),this.setAnimationLoop=function(Q){ue=Q},this.dispose=function(){}}},tr=new Oi,IM=new $t;function PM(i,e){function t(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function n(p,m){m.color.getRGB(p.fogColor.value,pu(i)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,y,A,w){m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),f(p,m)):m.isMeshPhongMaterial?(r(p,m),h(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),u(p,m),m.isMeshPhysicalMaterial&&d(p,m,w)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),M(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?l(p,m,y,A):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,t(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===In&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,t(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===In&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,t(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,t(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let y=e.get(m),A=y.envMap,w=y.envMapRotation;A&&(p.envMap.value=A,tr.copy(w),tr.x*=-1,tr.y*=-1,tr.z*=-1,A.isCubeTexture&&A.isRenderTargetTexture===!1&&(tr.y*=-1,tr.z*=-1),p.envMapRotation.value.setFromMatrix4(IM.makeRotationFromEuler(tr)),p.flipEnvMap.value=A.isCubeTexture&&A.isRenderTargetTexture===!1?-1:1,p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,y,A){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*y,p.scale.value=A*.5,m.map&&(p.map.value=m.map,t(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function h(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function f(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function u(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function d(p,m,y){p.ior.value=m.ior,m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===In&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessRange[0],p.iridescenceThicknessMaximum.value=m.iridescenceThicknessRange[1],m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=y.texture,p.transmissionSamplerSize.value.set(y.width,y.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function M(p,m){let y=e.get(m).light;p.referencePosition.value.setFromMatrixPosition(y.matrixWorld),p.nearDistance.value=y.shadow.camera.near,p.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function LM(i,e,t,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(y,A){let w=A.program;n.uniformBlockBinding(y,w)}function c(y,A){let w=s[y.id];w===void 0&&(g(y),w=h(y),s[y.id]=w,y.addEventListener("dispose",p));let D=A.program;n.updateUBOMapping(y,D);let R=e.render.frame;r[y.id]!==R&&(u(y),r[y.id]=R)}function h(y){let A=f();y.__bindingPointIndex=A;let w=i.createBuffer(),D=y.__size,R=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,w),i.bufferData(i.UNIFORM_BUFFER,D,R),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,A,w),w}function f(){for(let y=0;y<a;y++)if(o.indexOf(y)===-1)return o.push(y),y;return Xe("WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function u(y){let A=s[y.id],w=y.uniforms,D=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let R=0,N=w.length;R<N;R++){let v=Array.isArray(w[R])?w[R]:[w[R]];for(let T=0,q=v.length;T<q;T++){let E=v[T];if(d(E,R,T,D)===!0){let G=E.__offset,O=Array.isArray(E.value)?E.value:[E.value],W=0;for(let V=0;V<O.length;V++){let H=O[V],U=M(H);typeof H=="number"||typeof H=="boolean"?(E.__data[0]=H,i.bufferSubData(i.UNIFORM_BUFFER,G+W,E.__data)):H.isMatrix3?(E.__data[0]=H.elements[0],E.__data[1]=H.elements[1],E.__data[2]=H.elements[2],E.__data[3]=0,E.__data[4]=H.elements[3],E.__data[5]=H.elements[4],E.__data[6]=H.elements[5],E.__data[7]=0,E.__data[8]=H.elements[6],E.__data[9]=H.elements[7],E.__data[10]=H.elements[8],E.__data[11]=0):(H.toArray(E.__data,W),W+=U.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,G,E.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function d(y,A,w,D){let R=y.value,N=A+"_"+w;if(D[N]===void 0)return typeof R=="number"||typeof R=="boolean"?D[N]=R:D[N]=R.clone(),!0;{let v=D[N];if(typeof R=="number"||typeof R=="boolean"){if(v!==R)return D[N]=R,!0}else if(v.equals(R)===!1)return v.copy(R),!0}return!1}function g(y){let A=y.uniforms,w=0,D=16;for(let N=0,v=A.length;N<v;N++){let T=Array.isArray(A[N])?A[N]:[A[N]];for(let q=0,E=T.length;q<E;q++){let G=T[q],O=Array.isArray(G.value)?G.value:[G.value];for(let W=0,V=O.length;W<V;W++){let H=O[W],U=M(H),le=w%D,ie=le%U.boundary,ce=le+ie;w+=ie,ce!==0&&D-ce<U.storage&&(w+=D-ce),G.__data=new Float32Array(U.storage/Float32Array.BYTES_PER_ELEMENT),G.__offset=w,w+=U.storage}}}let R=w%D;return R>0&&(w+=D-R),y.__size=w,y.__cache={},this}function M(y){let A={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(A.boundary=4,A.storage=4):y.isVector2?(A.boundary=8,A.storage=8):y.isVector3||y.isColor?(A.boundary=16,A.storage=12):y.isVector4?(A.boundary=16,A.storage=16):y.isMatrix3?(A.boundary=48,A.storage=48):y.isMatrix4?(A.boundary=64,A.storage=64):y.isTexture?qe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):qe("WebGLRenderer: Unsupported uniform value type.",y),A}function p(y){let A=y.target;A.removeEventListener("dispose",p);let w=o.indexOf(A.__bindingPointIndex);o.splice(w,1),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function m(){for(let y in s)i.deleteBuffer(s[y]);o=[],s={},r={}}return{bind:l,update:c,dispose:m}}var DM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Vi=null;function NM(){return Vi===null&&(Vi=new ws(DM,16,16,js,zi),Vi.name="DFG_LUT",Vi.minFilter=gn,Vi.magFilter=gn,Vi.wrapS=Ni,Vi.wrapT=Ni,Vi.generateMipmaps=!1,Vi.needsUpdate=!0),Vi}var Ac=class{constructor(e={}){let{canvas:t=$d(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:u=!1,outputBufferType:d=bn}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let M=d,p=new Set([Jr,zl,kl]),m=new Set([bn,gi,$r,Zr,Ol,Bl]),y=new Uint32Array(4),A=new Int32Array(4),w=null,D=null,R=[],N=[],v=null;this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=mi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let T=this,q=!1;this._outputColorSpace=Xn;let E=0,G=0,O=null,W=-1,V=null,H=new Yt,U=new Yt,le=null,ie=new ft(0),ce=0,_e=t.width,oe=t.height,ue=1,et=null,it=null,Q=new Yt(0,0,_e,oe),re=new Yt(0,0,_e,oe),me=!1,He=new zo,Se=!1,Ge=!1,At=new $t,Ye=new Z,rt=new Yt,ht={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},$e=!1;function Rt(){return O===null?ue:1}let F=n;function Tt(S,X){return t.getContext(S,X)}try{let S={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"183"}`),t.addEventListener("webglcontextlost",Ue,!1),t.addEventListener("webglcontextrestored",Ke,!1),t.addEventListener("webglcontextcreationerror",Et,!1),F===null){let X="webgl2";if(F=Tt(X,S),F===null)throw Tt(X)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(S){throw Xe("WebGLRenderer: "+S.message),S}let Ze,dt,Ie,I,x,L,K,ne,ee,Pe,ge,Oe,Be,ae,he,we,Ne,Ae,Je,B,ve,fe,Le;function pe(){Ze=new Gv(F),Ze.init(),ve=new EM(F,Ze),dt=new Nv(F,Ze,e,ve),Ie=new AM(F,Ze),dt.reversedDepthBuffer&&u&&Ie.buffers.depth.setReversed(!0),I=new Xv(F),x=new uM,L=new TM(F,Ze,Ie,x,dt,ve,I),K=new Vv(T),ne=new J0(F),fe=new Lv(F,ne),ee=new Hv(F,ne,I,fe),Pe=new Yv(F,ee,ne,fe,I),Ae=new qv(F,dt,L),he=new Fv(x),ge=new hM(T,K,Ze,dt,fe,he),Oe=new PM(T,x),Be=new dM,ae=new vM(Ze),Ne=new Pv(T,K,Ie,Pe,g,l),we=new wM(T,Pe,dt),Le=new LM(F,I,dt,Ie),Je=new Dv(F,Ze,I),B=new Wv(F,Ze,I),I.programs=ge.programs,T.capabilities=dt,T.extensions=Ze,T.properties=x,T.renderLists=Be,T.shadowMap=we,T.state=Ie,T.info=I}pe(),M!==bn&&(v=new Zv(M,t.width,t.height,s,r));let te=new Lu(T,F);this.xr=te,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let S=Ze.get("WEBGL_lose_context");S&&S.loseContext()},this.forceContextRestore=function(){let S=Ze.get("WEBGL_lose_context");S&&S.restoreContext()},this.getPixelRatio=function(){return ue},this.setPixelRatio=function(S){S!==void 0&&(ue=S,this.setSize(_e,oe,!1))},this.getSize=function(S){return S.set(_e,oe)},this.setSize=function(S,X,j=!0){if(te.isPresenting){qe("WebGLRenderer: Can't change size while VR device is presenting.");return}_e=S,oe=X,t.width=Math.floor(S*ue),t.height=Math.floor(X*ue),j===!0&&(t.style.width=S+"px",t.style.height=X+"px"),v!==null&&v.setSize(t.width,t.height),this.setViewport(0,0,S,X)},this.getDrawingBufferSize=function(S){return S.set(_e*ue,oe*ue).floor()},this.setDrawingBufferSize=function(S,X,j){_e=S,oe=X,ue=j,t.width=Math.floor(S*j),t.height=Math.floor(X*j),this.setViewport(0,0,S,X)},this.setEffects=function(S){if(M===bn){console.error("THREE.WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(S){for(let X=0;X<S.length;X++)if(S[X].isOutputPass===!0){console.warn("THREE.WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}v.setEffects(S||[])},this.getCurrentViewport=function(S){return S.copy(H)},this.getViewport=function(S){return S.copy(Q)},this.setViewport=function(S,X,j,J){S.isVector4?Q.set(S.x,S.y,S.z,S.w):Q.set(S,X,j,J),Ie.viewport(H.copy(Q).multiplyScalar(ue).round())},this.getScissor=function(S){return S.copy(re)},this.setScissor=function(S,X,j,J){S.isVector4?re.set(S.x,S.y,S.z,S.w):re.set(S,X,j,J),Ie.scissor(U.copy(re).multiplyScalar(ue).round())},this.getScissorTest=function(){return me},this.setScissorTest=function(S){Ie.setScissorTest(me=S)},this.setOpaqueSort=function(S){et=S},this.setTransparentSort=function(S){it=S},this.getClearColor=function(S){return S.copy(Ne.getClearColor())},this.setClearColor=function(){Ne.setClearColor(...arguments)},this.getClearAlpha=function(){return Ne.getClearAlpha()},this.setClearAlpha=function(){Ne.setClearAlpha(...arguments)},this.clear=function(S=!0,X=!0,j=!0){let J=0;if(S){let Y=!1;if(O!==null){let ye=O.texture.format;Y=p.has(ye)}if(Y){let ye=O.texture.type,Ce=m.has(ye),Me=Ne.getClearColor(),Fe=Ne.getClearAlpha(),ke=Me.r,je=Me.g,tt=Me.b;Ce?(y[0]=ke,y[1]=je,y[2]=tt,y[3]=Fe,F.clearBufferuiv(F.COLOR,0,y)):(A[0]=ke,A[1]=je,A[2]=tt,A[3]=Fe,F.clearBufferiv(F.COLOR,0,A))}else J|=F.COLOR_BUFFER_BIT}X&&(J|=F.DEPTH_BUFFER_BIT),j&&(J|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&F.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",Ue,!1),t.removeEventListener("webglcontextrestored",Ke,!1),t.removeEventListener("webglcontextcreationerror",Et,!1),Ne.dispose(),Be.dispose(),ae.dispose(),x.dispose(),K.dispose(),Pe.dispose(),fe.dispose(),Le.dispose(),ge.dispose(),te.dispose(),te.removeEventListener("sessionstart",wn),te.removeEventListener("sessionend",Wi),Dn.stop()};function Ue(S){S.preventDefault(),du("WebGLRenderer: Context Lost."),q=!0}function Ke(){du("WebGLRenderer: Context Restored."),q=!1;let S=I.autoReset,X=we.enabled,j=we.autoUpdate,J=we.needsUpdate,Y=we.type;pe(),I.autoReset=S,we.enabled=X,we.autoUpdate=j,we.needsUpdate=J,we.type=Y}function Et(S){Xe("WebGLRenderer: A WebGL context could not be created. Reason: ",S.statusMessage)}function _t(S){let X=S.target;X.removeEventListener("dispose",_t),dn(X)}function dn(S){Lt(S),x.remove(S)}function Lt(S){let X=x.get(S).programs;X!==void 0&&(X.forEach(function(j){ge.releaseProgram(j)}),S.isShaderMaterial&&ge.releaseShaderCache(S))}this.renderBufferDirect=function(S,X,j,J,Y,ye){X===null&&(X=ht);let Ce=Y.isMesh&&Y.matrixWorld.determinant()<0,Me=Si(S,X,j,J,Y);Ie.setMaterial(J,Ce);let Fe=j.index,ke=1;if(J.wireframe===!0){if(Fe=ee.getWireframeAttribute(j),Fe===void 0)return;ke=2}let je=j.drawRange,tt=j.attributes.position,Ee=je.start*ke,xt=(je.start+je.count)*ke;ye!==null&&(Ee=Math.max(Ee,ye.start*ke),xt=Math.min(xt,(ye.start+ye.count)*ke)),Fe!==null?(Ee=Math.max(Ee,0),xt=Math.min(xt,Fe.count)):tt!=null&&(Ee=Math.max(Ee,0),xt=Math.min(xt,tt.count));let kt=xt-Ee;if(kt<0||kt===1/0)return;fe.setup(Y,J,Me,j,Fe);let Dt,vt=Je;if(Fe!==null&&(Dt=ne.get(Fe),vt=B,vt.setIndex(Dt)),Y.isMesh)J.wireframe===!0?(Ie.setLineWidth(J.wireframeLinewidth*Rt()),vt.setMode(F.LINES)):vt.setMode(F.TRIANGLES);else if(Y.isLine){let an=J.linewidth;an===void 0&&(an=1),Ie.setLineWidth(an*Rt()),Y.isLineSegments?vt.setMode(F.LINES):Y.isLineLoop?vt.setMode(F.LINE_LOOP):vt.setMode(F.LINE_STRIP)}else Y.isPoints?vt.setMode(F.POINTS):Y.isSprite&&vt.setMode(F.TRIANGLES);if(Y.isBatchedMesh)if(Y._multiDrawInstances!==null)Lo("WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),vt.renderMultiDrawInstances(Y._multiDrawStarts,Y._multiDrawCounts,Y._multiDrawCount,Y._multiDrawInstances);else if(Ze.get("WEBGL_multi_draw"))vt.renderMultiDraw(Y._multiDrawStarts,Y._multiDrawCounts,Y._multiDrawCount);else{let an=Y._multiDrawStarts,ze=Y._multiDrawCounts,An=Y._multiDrawCount,lt=Fe?ne.get(Fe).bytesPerElement:1,Nn=x.get(J).currentProgram.getUniforms();for(let ei=0;ei<An;ei++)Nn.setValue(F,"_gl_DrawID",ei),vt.render(an[ei]/lt,ze[ei])}else if(Y.isInstancedMesh)vt.renderInstances(Ee,kt,Y.count);else if(j.isInstancedBufferGeometry){let an=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,ze=Math.min(j.instanceCount,an);vt.renderInstances(Ee,kt,ze)}else vt.render(Ee,kt)};function Bn(S,X,j){S.transparent===!0&&S.side===Bi&&S.forceSinglePass===!1?(S.side=In,S.needsUpdate=!0,pr(S,X,j),S.side=ji,S.needsUpdate=!0,pr(S,X,j),S.side=Bi):pr(S,X,j)}this.compile=function(S,X,j=null){j===null&&(j=S),D=ae.get(j),D.init(X),N.push(D),j.traverseVisible(function(Y){Y.isLight&&Y.layers.test(X.layers)&&(D.pushLight(Y),Y.castShadow&&D.pushShadow(Y))}),S!==j&&S.traverseVisible(function(Y){Y.isLight&&Y.layers.test(X.layers)&&(D.pushLight(Y),Y.castShadow&&D.pushShadow(Y))}),D.setupLights();let J=new Set;return S.traverse(function(Y){if(!(Y.isMesh||Y.isPoints||Y.isLine||Y.isSprite))return;let ye=Y.material;if(ye)if(Array.isArray(ye))for(let Ce=0;Ce<ye.length;Ce++){let Me=ye[Ce];Bn(Me,j,Y),J.add(Me)}else Bn(ye,j,Y),J.add(ye)}),D=N.pop(),J},this.compileAsync=function(S,X,j=null){let J=this.compile(S,X,j);return new Promise(Y=>{function ye(){if(J.forEach(function(Ce){x.get(Ce).currentProgram.isReady()&&J.delete(Ce)}),J.size===0){Y(S);return}setTimeout(ye,10)}Ze.get("KHR_parallel_shader_compile")!==null?ye():setTimeout(ye,10)})};let Mi=null;function os(S){Mi&&Mi(S)}function wn(){Dn.stop()}function Wi(){Dn.start()}let Dn=new Sp;Dn.setAnimationLoop(os),typeof self<"u"&&Dn.setContext(self),this.setAnimationLoop=function(S){Mi=S,te.setAnimationLoop(S),S===null?Dn.stop():Dn.start()},te.addEventListener("sessionstart",wn),te.addEventListener("sessionend",Wi),this.render=function(S,X){if(X!==void 0&&X.isCamera!==!0){Xe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(q===!0)return;let j=te.enabled===!0&&te.isPresenting===!0,J=v!==null&&(O===null||j)&&v.begin(T,O);if(S.matrixWorldAutoUpdate===!0&&S.updateMatrixWorld(),X.parent===null&&X.matrixWorldAutoUpdate===!0&&X.updateMatrixWorld(),te.enabled===!0&&te.isPresenting===!0&&(v===null||v.isCompositing()===!1)&&(te.cameraAutoUpdate===!0&&te.updateCamera(X),X=te.getCamera()),S.isScene===!0&&S.onBeforeRender(T,S,X,O),D=ae.get(S,N.length),D.init(X),N.push(D),At.multiplyMatrices(X.projectionMatrix,X.matrixWorldInverse),He.setFromProjectionMatrix(At,pi,X.reversedDepth),Ge=this.localClippingEnabled,Se=he.init(this.clippingPlanes,Ge),w=Be.get(S,R.length),w.init(),R.push(w),te.enabled===!0&&te.isPresenting===!0){let Ce=T.xr.getDepthSensingMesh();Ce!==null&&fr(Ce,X,-1/0,T.sortObjects)}fr(S,X,0,T.sortObjects),w.finish(),T.sortObjects===!0&&w.sort(et,it),$e=te.enabled===!1||te.isPresenting===!1||te.hasDepthSensing()===!1,$e&&Ne.addToRenderList(w,S),this.info.render.frame++,Se===!0&&he.beginShadows();let Y=D.state.shadowsArray;if(we.render(Y,S,X),Se===!0&&he.endShadows(),this.info.autoReset===!0&&this.info.reset(),(J&&v.hasRenderPass())===!1){let Ce=w.opaque,Me=w.transmissive;if(D.setupLights(),X.isArrayCamera){let Fe=X.cameras;if(Me.length>0)for(let ke=0,je=Fe.length;ke<je;ke++){let tt=Fe[ke];va(Ce,Me,S,tt)}$e&&Ne.render(S);for(let ke=0,je=Fe.length;ke<je;ke++){let tt=Fe[ke];mo(w,S,tt,tt.viewport)}}else Me.length>0&&va(Ce,Me,S,X),$e&&Ne.render(S),mo(w,S,X)}O!==null&&G===0&&(L.updateMultisampleRenderTarget(O),L.updateRenderTargetMipmap(O)),J&&v.end(T),S.isScene===!0&&S.onAfterRender(T,S,X),fe.resetDefaultState(),W=-1,V=null,N.pop(),N.length>0?(D=N[N.length-1],Se===!0&&he.setGlobalState(T.clippingPlanes,D.state.camera)):D=null,R.pop(),R.length>0?w=R[R.length-1]:w=null};function fr(S,X,j,J){if(S.visible===!1)return;if(S.layers.test(X.layers)){if(S.isGroup)j=S.renderOrder;else if(S.isLOD)S.autoUpdate===!0&&S.update(X);else if(S.isLight)D.pushLight(S),S.castShadow&&D.pushShadow(S);else if(S.isSprite){if(!S.frustumCulled||He.intersectsSprite(S)){J&&rt.setFromMatrixPosition(S.matrixWorld).applyMatrix4(At);let Ce=Pe.update(S),Me=S.material;Me.visible&&w.push(S,Ce,Me,j,rt.z,null)}}else if((S.isMesh||S.isLine||S.isPoints)&&(!S.frustumCulled||He.intersectsObject(S))){let Ce=Pe.update(S),Me=S.material;if(J&&(S.boundingSphere!==void 0?(S.boundingSphere===null&&S.computeBoundingSphere(),rt.copy(S.boundingSphere.center)):(Ce.boundingSphere===null&&Ce.computeBoundingSphere(),rt.copy(Ce.boundingSphere.center)),rt.applyMatrix4(S.matrixWorld).applyMatrix4(At)),Array.isArray(Me)){let Fe=Ce.groups;for(let ke=0,je=Fe.length;ke<je;ke++){let tt=Fe[ke],Ee=Me[tt.materialIndex];Ee&&Ee.visible&&w.push(S,Ce,Ee,j,rt.z,tt)}}else Me.visible&&w.push(S,Ce,Me,j,rt.z,null)}}let ye=S.children;for(let Ce=0,Me=ye.length;Ce<Me;Ce++)fr(ye[Ce],X,j,J)}function mo(S,X,j,J){let{opaque:Y,transmissive:ye,transparent:Ce}=S;D.setupLightsView(j),Se===!0&&he.setGlobalState(T.clippingPlanes,j),J&&Ie.viewport(H.copy(J)),Y.length>0&&dr(Y,X,j),ye.length>0&&dr(ye,X,j),Ce.length>0&&dr(Ce,X,j),Ie.buffers.depth.setTest(!0),Ie.buffers.depth.setMask(!0),Ie.buffers.color.setMask(!0),Ie.setPolygonOffset(!1)}function va(S,X,j,J){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(D.state.transmissionRenderTarget[J.id]===void 0){let Ee=Ze.has("EXT_color_buffer_half_float")||Ze.has("EXT_color_buffer_float");D.state.transmissionRenderTarget[J.id]=new Rn(1,1,{generateMipmaps:!0,type:Ee?zi:bn,minFilter:Is,samples:Math.max(4,dt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ut.workingColorSpace})}let ye=D.state.transmissionRenderTarget[J.id],Ce=J.viewport||H;ye.setSize(Ce.z*T.transmissionResolutionScale,Ce.w*T.transmissionResolutionScale);let Me=T.getRenderTarget(),Fe=T.getActiveCubeFace(),ke=T.getActiveMipmapLevel();T.setRenderTarget(ye),T.getClearColor(ie),ce=T.getClearAlpha(),ce<1&&T.setClearColor(16777215,.5),T.clear(),$e&&Ne.render(j);let je=T.toneMapping;T.toneMapping=mi;let tt=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),D.setupLightsView(J),Se===!0&&he.setGlobalState(T.clippingPlanes,J),dr(S,j,J),L.updateMultisampleRenderTarget(ye),L.updateRenderTargetMipmap(ye),Ze.has("WEBGL_multisampled_render_to_texture")===!1){let Ee=!1;for(let xt=0,kt=X.length;xt<kt;xt++){let Dt=X[xt],{object:vt,geometry:an,material:ze,group:An}=Dt;if(ze.side===Bi&&vt.layers.test(J.layers)){let lt=ze.side;ze.side=In,ze.needsUpdate=!0,bi(vt,j,J,an,ze,An),ze.side=lt,ze.needsUpdate=!0,Ee=!0}}Ee===!0&&(L.updateMultisampleRenderTarget(ye),L.updateRenderTargetMipmap(ye))}T.setRenderTarget(Me,Fe,ke),T.setClearColor(ie,ce),tt!==void 0&&(J.viewport=tt),T.toneMapping=je}function dr(S,X,j){let J=X.isScene===!0?X.overrideMaterial:null;for(let Y=0,ye=S.length;Y<ye;Y++){let Ce=S[Y],{object:Me,geometry:Fe,group:ke}=Ce,je=Ce.material;je.allowOverride===!0&&J!==null&&(je=J),Me.layers.test(j.layers)&&bi(Me,X,j,Fe,je,ke)}}function bi(S,X,j,J,Y,ye){S.onBeforeRender(T,X,j,J,Y,ye),S.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,S.matrixWorld),S.normalMatrix.getNormalMatrix(S.modelViewMatrix),Y.onBeforeRender(T,X,j,J,S,ye),Y.transparent===!0&&Y.side===Bi&&Y.forceSinglePass===!1?(Y.side=In,Y.needsUpdate=!0,T.renderBufferDirect(j,X,J,Y,S,ye),Y.side=ji,Y.needsUpdate=!0,T.renderBufferDirect(j,X,J,Y,S,ye),Y.side=Bi):T.renderBufferDirect(j,X,J,Y,S,ye),S.onAfterRender(T,X,j,J,Y,ye)}function pr(S,X,j){X.isScene!==!0&&(X=ht);let J=x.get(S),Y=D.state.lights,ye=D.state.shadowsArray,Ce=Y.state.version,Me=ge.getParameters(S,Y.state,ye,X,j),Fe=ge.getProgramCacheKey(Me),ke=J.programs;J.environment=S.isMeshStandardMaterial||S.isMeshLambertMaterial||S.isMeshPhongMaterial?X.environment:null,J.fog=X.fog;let je=S.isMeshStandardMaterial||S.isMeshLambertMaterial&&!S.envMap||S.isMeshPhongMaterial&&!S.envMap;J.envMap=K.get(S.envMap||J.environment,je),J.envMapRotation=J.environment!==null&&S.envMap===null?X.environmentRotation:S.envMapRotation,ke===void 0&&(S.addEventListener("dispose",_t),ke=new Map,J.programs=ke);let tt=ke.get(Fe);if(tt!==void 0){if(J.currentProgram===tt&&J.lightsStateVersion===Ce)return go(S,Me),tt}else Me.uniforms=ge.getUniforms(S),S.onBeforeCompile(Me,T),tt=ge.acquireProgram(Me,Fe),ke.set(Fe,tt),J.uniforms=Me.uniforms;let Ee=J.uniforms;return(!S.isShaderMaterial&&!S.isRawShaderMaterial||S.clipping===!0)&&(Ee.clippingPlanes=he.uniform),go(S,Me),J.needsLights=Zt(S),J.lightsStateVersion=Ce,J.needsLights&&(Ee.ambientLightColor.value=Y.state.ambient,Ee.lightProbe.value=Y.state.probe,Ee.directionalLights.value=Y.state.directional,Ee.directionalLightShadows.value=Y.state.directionalShadow,Ee.spotLights.value=Y.state.spot,Ee.spotLightShadows.value=Y.state.spotShadow,Ee.rectAreaLights.value=Y.state.rectArea,Ee.ltc_1.value=Y.state.rectAreaLTC1,Ee.ltc_2.value=Y.state.rectAreaLTC2,Ee.pointLights.value=Y.state.point,Ee.pointLightShadows.value=Y.state.pointShadow,Ee.hemisphereLights.value=Y.state.hemi,Ee.directionalShadowMatrix.value=Y.state.directionalShadowMatrix,Ee.spotLightMatrix.value=Y.state.spotLightMatrix,Ee.spotLightMap.value=Y.state.spotLightMap,Ee.pointShadowMatrix.value=Y.state.pointShadowMatrix),J.currentProgram=tt,J.uniformsList=null,tt}function as(S){if(S.uniformsList===null){let X=S.currentProgram.getUniforms();S.uniformsList=jr.seqWithValue(X.seq,S.uniforms)}return S.uniformsList}function go(S,X){let j=x.get(S);j.outputColorSpace=X.outputColorSpace,j.batching=X.batching,j.batchingColor=X.batchingColor,j.instancing=X.instancing,j.instancingColor=X.instancingColor,j.instancingMorph=X.instancingMorph,j.skinning=X.skinning,j.morphTargets=X.morphTargets,j.morphNormals=X.morphNormals,j.morphColors=X.morphColors,j.morphTargetsCount=X.morphTargetsCount,j.numClippingPlanes=X.numClippingPlanes,j.numIntersection=X.numClipIntersection,j.vertexAlphas=X.vertexAlphas,j.vertexTangents=X.vertexTangents,j.toneMapping=X.toneMapping}function Si(S,X,j,J,Y){X.isScene!==!0&&(X=ht),L.resetTextureUnits();let ye=X.fog,Ce=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?X.environment:null,Me=O===null?T.outputColorSpace:O.isXRRenderTarget===!0?O.texture.colorSpace:Zs,Fe=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,ke=K.get(J.envMap||Ce,Fe),je=J.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,tt=!!j.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),Ee=!!j.morphAttributes.position,xt=!!j.morphAttributes.normal,kt=!!j.morphAttributes.color,Dt=mi;J.toneMapped&&(O===null||O.isXRRenderTarget===!0)&&(Dt=T.toneMapping);let vt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,an=vt!==void 0?vt.length:0,ze=x.get(J),An=D.state.lights;if(Se===!0&&(Ge===!0||S!==V)){let Ht=S===V&&J.id===W;he.setState(J,S,Ht)}let lt=!1;J.version===ze.__version?(ze.needsLights&&ze.lightsStateVersion!==An.state.version||ze.outputColorSpace!==Me||Y.isBatchedMesh&&ze.batching===!1||!Y.isBatchedMesh&&ze.batching===!0||Y.isBatchedMesh&&ze.batchingColor===!0&&Y.colorTexture===null||Y.isBatchedMesh&&ze.batchingColor===!1&&Y.colorTexture!==null||Y.isInstancedMesh&&ze.instancing===!1||!Y.isInstancedMesh&&ze.instancing===!0||Y.isSkinnedMesh&&ze.skinning===!1||!Y.isSkinnedMesh&&ze.skinning===!0||Y.isInstancedMesh&&ze.instancingColor===!0&&Y.instanceColor===null||Y.isInstancedMesh&&ze.instancingColor===!1&&Y.instanceColor!==null||Y.isInstancedMesh&&ze.instancingMorph===!0&&Y.morphTexture===null||Y.isInstancedMesh&&ze.instancingMorph===!1&&Y.morphTexture!==null||ze.envMap!==ke||J.fog===!0&&ze.fog!==ye||ze.numClippingPlanes!==void 0&&(ze.numClippingPlanes!==he.numPlanes||ze.numIntersection!==he.numIntersection)||ze.vertexAlphas!==je||ze.vertexTangents!==tt||ze.morphTargets!==Ee||ze.morphNormals!==xt||ze.morphColors!==kt||ze.toneMapping!==Dt||ze.morphTargetsCount!==an)&&(lt=!0):(lt=!0,ze.__version=J.version);let Nn=ze.currentProgram;lt===!0&&(Nn=pr(J,X,Y));let ei=!1,wi=!1,Ai=!1,pt=Nn.getUniforms(),Gt=ze.uniforms;if(Ie.useProgram(Nn.program)&&(ei=!0,wi=!0,Ai=!0),J.id!==W&&(W=J.id,wi=!0),ei||V!==S){Ie.buffers.depth.getReversed()&&S.reversedDepth!==!0&&(S._reversedDepth=!0,S.updateProjectionMatrix()),pt.setValue(F,"projectionMatrix",S.projectionMatrix),pt.setValue(F,"viewMatrix",S.matrixWorldInverse);let Ei=pt.map.cameraPosition;Ei!==void 0&&Ei.setValue(F,Ye.setFromMatrixPosition(S.matrixWorld)),dt.logarithmicDepthBuffer&&pt.setValue(F,"logDepthBufFC",2/(Math.log(S.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&pt.setValue(F,"isOrthographic",S.isOrthographicCamera===!0),V!==S&&(V=S,wi=!0,Ai=!0)}if(ze.needsLights&&(An.state.directionalShadowMap.length>0&&pt.setValue(F,"directionalShadowMap",An.state.directionalShadowMap,L),An.state.spotShadowMap.length>0&&pt.setValue(F,"spotShadowMap",An.state.spotShadowMap,L),An.state.pointShadowMap.length>0&&pt.setValue(F,"pointShadowMap",An.state.pointShadowMap,L)),Y.isSkinnedMesh){pt.setOptional(F,Y,"bindMatrix"),pt.setOptional(F,Y,"bindMatrixInverse");let Ht=Y.skeleton;Ht&&(Ht.boneTexture===null&&Ht.computeBoneTexture(),pt.setValue(F,"boneTexture",Ht.boneTexture,L))}Y.isBatchedMesh&&(pt.setOptional(F,Y,"batchingTexture"),pt.setValue(F,"batchingTexture",Y._matricesTexture,L),pt.setOptional(F,Y,"batchingIdTexture"),pt.setValue(F,"batchingIdTexture",Y._indirectTexture,L),pt.setOptional(F,Y,"batchingColorTexture"),Y._colorsTexture!==null&&pt.setValue(F,"batchingColorTexture",Y._colorsTexture,L));let Ti=j.morphAttributes;if((Ti.position!==void 0||Ti.normal!==void 0||Ti.color!==void 0)&&Ae.update(Y,j,Nn),(wi||ze.receiveShadow!==Y.receiveShadow)&&(ze.receiveShadow=Y.receiveShadow,pt.setValue(F,"receiveShadow",Y.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&X.environment!==null&&(Gt.envMapIntensity.value=X.environmentIntensity),Gt.dfgLUT!==void 0&&(Gt.dfgLUT.value=NM()),wi&&(pt.setValue(F,"toneMappingExposure",T.toneMappingExposure),ze.needsLights&&tn(Gt,Ai),ye&&J.fog===!0&&Oe.refreshFogUniforms(Gt,ye),Oe.refreshMaterialUniforms(Gt,J,ue,oe,D.state.transmissionRenderTarget[S.id]),jr.upload(F,as(ze),Gt,L)),J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(jr.upload(F,as(ze),Gt,L),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&pt.setValue(F,"center",Y.center),pt.setValue(F,"modelViewMatrix",Y.modelViewMatrix),pt.setValue(F,"normalMatrix",Y.normalMatrix),pt.setValue(F,"modelMatrix",Y.matrixWorld),J.isShaderMaterial||J.isRawShaderMaterial){let Ht=J.uniformsGroups;for(let Ei=0,ls=Ht.length;Ei<ls;Ei++){let ya=Ht[Ei];Le.update(ya,Nn),Le.bind(ya,Nn)}}return Nn}function tn(S,X){S.ambientLightColor.needsUpdate=X,S.lightProbe.needsUpdate=X,S.directionalLights.needsUpdate=X,S.directionalLightShadows.needsUpdate=X,S.pointLights.needsUpdate=X,S.pointLightShadows.needsUpdate=X,S.spotLights.needsUpdate=X,S.spotLightShadows.needsUpdate=X,S.rectAreaLights.needsUpdate=X,S.hemisphereLights.needsUpdate=X}function Zt(S){return S.isMeshLambertMaterial||S.isMeshToonMaterial||S.isMeshPhongMaterial||S.isMeshStandardMaterial||S.isShadowMaterial||S.isShaderMaterial&&S.lights===!0}this.getActiveCubeFace=function(){return E},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return O},this.setRenderTargetTextures=function(S,X,j){let J=x.get(S);J.__autoAllocateDepthBuffer=S.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),x.get(S.texture).__webglTexture=X,x.get(S.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:j,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(S,X){let j=x.get(S);j.__webglFramebuffer=X,j.__useDefaultFramebuffer=X===void 0};let Jt=F.createFramebuffer();this.setRenderTarget=function(S,X=0,j=0){O=S,E=X,G=j;let J=null,Y=!1,ye=!1;if(S){let Me=x.get(S);if(Me.__useDefaultFramebuffer!==void 0){Ie.bindFramebuffer(F.FRAMEBUFFER,Me.__webglFramebuffer),H.copy(S.viewport),U.copy(S.scissor),le=S.scissorTest,Ie.viewport(H),Ie.scissor(U),Ie.setScissorTest(le),W=-1;return}else if(Me.__webglFramebuffer===void 0)L.setupRenderTarget(S);else if(Me.__hasExternalTextures)L.rebindTextures(S,x.get(S.texture).__webglTexture,x.get(S.depthTexture).__webglTexture);else if(S.depthBuffer){let je=S.depthTexture;if(Me.__boundDepthTexture!==je){if(je!==null&&x.has(je)&&(S.width!==je.image.width||S.height!==je.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");L.setupDepthRenderbuffer(S)}}let Fe=S.texture;(Fe.isData3DTexture||Fe.isDataArrayTexture||Fe.isCompressedArrayTexture)&&(ye=!0);let ke=x.get(S).__webglFramebuffer;S.isWebGLCubeRenderTarget?(Array.isArray(ke[X])?J=ke[X][j]:J=ke[X],Y=!0):S.samples>0&&L.useMultisampledRTT(S)===!1?J=x.get(S).__webglMultisampledFramebuffer:Array.isArray(ke)?J=ke[j]:J=ke,H.copy(S.viewport),U.copy(S.scissor),le=S.scissorTest}else H.copy(Q).multiplyScalar(ue).floor(),U.copy(re).multiplyScalar(ue).floor(),le=me;if(j!==0&&(J=Jt),Ie.bindFramebuffer(F.FRAMEBUFFER,J)&&Ie.drawBuffers(S,J),Ie.viewport(H),Ie.scissor(U),Ie.setScissorTest(le),Y){let Me=x.get(S.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+X,Me.__webglTexture,j)}else if(ye){let Me=X;for(let Fe=0;Fe<S.textures.length;Fe++){let ke=x.get(S.textures[Fe]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+Fe,ke.__webglTexture,j,Me)}}else if(S!==null&&j!==0){let Me=x.get(S.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Me.__webglTexture,j)}W=-1},this.readRenderTargetPixels=function(S,X,j,J,Y,ye,Ce,Me=0){if(!(S&&S.isWebGLRenderTarget)){Xe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Fe=x.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&Ce!==void 0&&(Fe=Fe[Ce]),Fe){Ie.bindFramebuffer(F.FRAMEBUFFER,Fe);try{let ke=S.textures[Me],je=ke.format,tt=ke.type;if(S.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Me),!dt.textureFormatReadable(je)){Xe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!dt.textureTypeReadable(tt)){Xe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}X>=0&&X<=S.width-J&&j>=0&&j<=S.height-Y&&F.readPixels(X,j,J,Y,ve.convert(je),ve.convert(tt),ye)}finally{let ke=O!==null?x.get(O).__webglFramebuffer:null;Ie.bindFramebuffer(F.FRAMEBUFFER,ke)}}},this.readRenderTargetPixelsAsync=async function(S,X,j,J,Y,ye,Ce,Me=0){if(!(S&&S.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Fe=x.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&Ce!==void 0&&(Fe=Fe[Ce]),Fe)if(X>=0&&X<=S.width-J&&j>=0&&j<=S.height-Y){Ie.bindFramebuffer(F.FRAMEBUFFER,Fe);let ke=S.textures[Me],je=ke.format,tt=ke.type;if(S.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Me),!dt.textureFormatReadable(je))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!dt.textureTypeReadable(tt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Ee=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,Ee),F.bufferData(F.PIXEL_PACK_BUFFER,ye.byteLength,F.STREAM_READ),F.readPixels(X,j,J,Y,ve.convert(je),ve.convert(tt),0);let xt=O!==null?x.get(O).__webglFramebuffer:null;Ie.bindFramebuffer(F.FRAMEBUFFER,xt);let kt=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await Jd(F,kt,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,Ee),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,ye),F.deleteBuffer(Ee),F.deleteSync(kt),ye}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(S,X=null,j=0){let J=Math.pow(2,-j),Y=Math.floor(S.image.width*J),ye=Math.floor(S.image.height*J),Ce=X!==null?X.x:0,Me=X!==null?X.y:0;L.setTexture2D(S,0),F.copyTexSubImage2D(F.TEXTURE_2D,j,0,0,Ce,Me,Y,ye),Ie.unbindTexture()};let mr=F.createFramebuffer(),kn=F.createFramebuffer();this.copyTextureToTexture=function(S,X,j=null,J=null,Y=0,ye=0){let Ce,Me,Fe,ke,je,tt,Ee,xt,kt,Dt=S.isCompressedTexture?S.mipmaps[ye]:S.image;if(j!==null)Ce=j.max.x-j.min.x,Me=j.max.y-j.min.y,Fe=j.isBox3?j.max.z-j.min.z:1,ke=j.min.x,je=j.min.y,tt=j.isBox3?j.min.z:0;else{let Gt=Math.pow(2,-Y);Ce=Math.floor(Dt.width*Gt),Me=Math.floor(Dt.height*Gt),S.isDataArrayTexture?Fe=Dt.depth:S.isData3DTexture?Fe=Math.floor(Dt.depth*Gt):Fe=1,ke=0,je=0,tt=0}J!==null?(Ee=J.x,xt=J.y,kt=J.z):(Ee=0,xt=0,kt=0);let vt=ve.convert(X.format),an=ve.convert(X.type),ze;X.isData3DTexture?(L.setTexture3D(X,0),ze=F.TEXTURE_3D):X.isDataArrayTexture||X.isCompressedArrayTexture?(L.setTexture2DArray(X,0),ze=F.TEXTURE_2D_ARRAY):(L.setTexture2D(X,0),ze=F.TEXTURE_2D),F.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,X.flipY),F.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,X.premultiplyAlpha),F.pixelStorei(F.UNPACK_ALIGNMENT,X.unpackAlignment);let An=F.getParameter(F.UNPACK_ROW_LENGTH),lt=F.getParameter(F.UNPACK_IMAGE_HEIGHT),Nn=F.getParameter(F.UNPACK_SKIP_PIXELS),ei=F.getParameter(F.UNPACK_SKIP_ROWS),wi=F.getParameter(F.UNPACK_SKIP_IMAGES);F.pixelStorei(F.UNPACK_ROW_LENGTH,Dt.width),F.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Dt.height),F.pixelStorei(F.UNPACK_SKIP_PIXELS,ke),F.pixelStorei(F.UNPACK_SKIP_ROWS,je),F.pixelStorei(F.UNPACK_SKIP_IMAGES,tt);let Ai=S.isDataArrayTexture||S.isData3DTexture,pt=X.isDataArrayTexture||X.isData3DTexture;if(S.isDepthTexture){let Gt=x.get(S),Ti=x.get(X),Ht=x.get(Gt.__renderTarget),Ei=x.get(Ti.__renderTarget);Ie.bindFramebuffer(F.READ_FRAMEBUFFER,Ht.__webglFramebuffer),Ie.bindFramebuffer(F.DRAW_FRAMEBUFFER,Ei.__webglFramebuffer);for(let ls=0;ls<Fe;ls++)Ai&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,x.get(S).__webglTexture,Y,tt+ls),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,x.get(X).__webglTexture,ye,kt+ls)),F.blitFramebuffer(ke,je,Ce,Me,Ee,xt,Ce,Me,F.DEPTH_BUFFER_BIT,F.NEAREST);Ie.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ie.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(Y!==0||S.isRenderTargetTexture||x.has(S)){let Gt=x.get(S),Ti=x.get(X);Ie.bindFramebuffer(F.READ_FRAMEBUFFER,mr),Ie.bindFramebuffer(F.DRAW_FRAMEBUFFER,kn);for(let Ht=0;Ht<Fe;Ht++)Ai?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Gt.__webglTexture,Y,tt+Ht):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Gt.__webglTexture,Y),pt?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ti.__webglTexture,ye,kt+Ht):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ti.__webglTexture,ye),Y!==0?F.blitFramebuffer(ke,je,Ce,Me,Ee,xt,Ce,Me,F.COLOR_BUFFER_BIT,F.NEAREST):pt?F.copyTexSubImage3D(ze,ye,Ee,xt,kt+Ht,ke,je,Ce,Me):F.copyTexSubImage2D(ze,ye,Ee,xt,ke,je,Ce,Me);Ie.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ie.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else pt?S.isDataTexture||S.isData3DTexture?F.texSubImage3D(ze,ye,Ee,xt,kt,Ce,Me,Fe,vt,an,Dt.data):X.isCompressedArrayTexture?F.compressedTexSubImage3D(ze,ye,Ee,xt,kt,Ce,Me,Fe,vt,Dt.data):F.texSubImage3D(ze,ye,Ee,xt,kt,Ce,Me,Fe,vt,an,Dt):S.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,ye,Ee,xt,Ce,Me,vt,an,Dt.data):S.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,ye,Ee,xt,Dt.width,Dt.height,vt,Dt.data):F.texSubImage2D(F.TEXTURE_2D,ye,Ee,xt,Ce,Me,vt,an,Dt);F.pixelStorei(F.UNPACK_ROW_LENGTH,An),F.pixelStorei(F.UNPACK_IMAGE_HEIGHT,lt),F.pixelStorei(F.UNPACK_SKIP_PIXELS,Nn),F.pixelStorei(F.UNPACK_SKIP_ROWS,ei),F.pixelStorei(F.UNPACK_SKIP_IMAGES,wi),ye===0&&X.generateMipmaps&&F.generateMipmap(ze),Ie.unbindTexture()},this.initRenderTarget=function(S){x.get(S).__webglFramebuffer===void 0&&L.setupRenderTarget(S)},this.initTexture=function(S){S.isCubeTexture?L.setTextureCube(S,0):S.isData3DTexture?L.setTexture3D(S,0):S.isDataArrayTexture||S.isCompressedArrayTexture?L.setTexture2DArray(S,0):L.setTexture2D(S,0),Ie.unbindTexture()},this.resetState=function(){E=0,G=0,O=null,Ie.reset(),fe.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return pi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=ut._getDrawingBufferColorSpace(e),t.unpackColorSpace=ut._getUnpackColorSpace()}};var ra=Math.PI/2,Du=(i,e,t)=>Math.min(t,Math.max(e,i)),Cc=class i{constructor(e,t){this.mesh=e,this.changed=t,this.planar=e.dimension===2,this.camera=new Js,this.aspect=1,this.fitted=!0,Object.assign(this,this.home(),{target:[0,0,0],halfHeight:1})}home(){if(this.planar)return{azimuth:-ra,elevation:ra};let{low:e,high:t}=this.mesh.box,n=t.map((c,h)=>c-e[h]),s=Math.max(...n)||1,[r,o,a]=n.map(c=>1+1.6*(1-c/s)),l=[.62*r,-1.05*o,.68*a];return{azimuth:Math.atan2(l[1],l[0]),elevation:Math.atan2(l[2],Math.hypot(l[0],l[1]))}}axes(){let{azimuth:e,elevation:t}=this,n=[Math.cos(t)*Math.cos(e),Math.cos(t)*Math.sin(e),Math.sin(t)],s=[-Math.sin(t)*Math.cos(e),-Math.sin(t)*Math.sin(e),Math.cos(t)];return{right:[-Math.sin(e),Math.cos(e),0],up:s,eye:n}}cameraFor(e){let{camera:t,mesh:n,target:s,halfHeight:r}=this,{up:o,eye:a}=this.axes(),l=3*n.box.diagonal;return t.up.fromArray(o),t.position.fromArray(s).addScaledVector(new Z().fromArray(a),l),t.lookAt(...s),t.top=r,t.bottom=-r,t.right=r*e,t.left=-t.right,t.near=0,t.far=2*l,t.updateProjectionMatrix(),t.updateMatrixWorld(),t}set(e,{keepFitted:t=!1}={}){Object.assign(this,e),this.elevation=Du(this.elevation,-ra,ra),t||(this.fitted=!1),this.changed()}turn(e,t){this.planar||this.set({azimuth:this.azimuth-e*.008,elevation:this.elevation+t*.008})}pan(e,t,n){let{right:s,up:r}=this.axes(),o=2*this.halfHeight/n;this.set({target:this.target.map((a,l)=>a-s[l]*e*o+r[l]*t*o)})}zoom(e,t=0,n=0){let{right:s,up:r}=this.axes(),o=Du(this.halfHeight*e,1e-6*this.mesh.box.diagonal,5*this.mesh.box.diagonal),a=this.halfHeight-o;this.set({halfHeight:o,target:this.target.map((l,c)=>l+(s[c]*t+r[c]*n)*a)})}whole(e=this){let{right:t,up:n}=i.prototype.axes.call(e),{before:s,after:r,vertexCount:o}=this.mesh,a=Math.max(1,Math.floor(o/5e4)),l=1/0,c=-1/0,h=1/0,f=-1/0;for(let M of r?[s,r]:[s])for(let p=0;p<o;p+=a){let m=4*p,y=M[m]*t[0]+M[m+1]*t[1],A=M[m]*n[0]+M[m+1]*n[1]+M[m+2]*n[2];l=Math.min(l,y),c=Math.max(c,y),h=Math.min(h,A),f=Math.max(f,A)}if(!(c>=l))return{target:[0,0,0],halfHeight:1};let u=(l+c)/2,d=(h+f)/2,g=Math.max((f-h)/2,(c-l)/2/this.aspect)*1.08;return{target:t.map((M,p)=>M*u+n[p]*d),halfHeight:g||1}}fit(){this.stop(),this.set({...this.whole()},{keepFitted:!0}),this.fitted=!0}get flying(){return this.flight!==void 0}stop(){this.flight!==void 0&&cancelAnimationFrame(this.flight),this.flight=void 0}fly(e,{fitted:t=!1}={}){this.stop();let n={target:this.target,halfHeight:this.halfHeight,azimuth:this.azimuth,elevation:this.elevation},s={...n,...e};s.azimuth=n.azimuth+FM(s.azimuth-n.azimuth);let r=()=>{this.flight=void 0,this.set(s,{keepFitted:t}),t&&(this.fitted=!0)};if(matchMedia("(prefers-reduced-motion: reduce)").matches)return r();let o=performance.now(),a=l=>{let c=Du((l-o)/450,0,1);if(c>=1)return r();let h=c*c*(3-2*c),f=(u,d)=>u+(d-u)*h;this.set({target:n.target.map((u,d)=>f(u,s.target[d])),halfHeight:n.halfHeight*(s.halfHeight/n.halfHeight)**h,azimuth:f(n.azimuth,s.azimuth),elevation:f(n.elevation,s.elevation)}),this.flight=requestAnimationFrame(a)};this.flight=requestAnimationFrame(a)}};function FM(i){return i-2*Math.PI*Math.round(i/(2*Math.PI))}function Rc([i,e,t]){let n=Math.hypot(i,e);return{azimuth:n>1e-9?Math.atan2(e,i):-ra,elevation:Math.atan2(t,n)}}function Cp(i,e,t){let n=[],s=[];if(i.after){let o=ks("Arrangement",[["side","Side by side","Two linked pictures (1)"],["wipe","Wipe","One picture, with a border to drag (2)"],["single","Single","One picture at a time (3)"]],c=>e.set({mode:c})),a=i.stops.length-1,l=bo("From before to after",{min:0,max:a,step:a>1?.05:.01},c=>e.set({scrub:c}));s.push(e.on(["mode"],({mode:c})=>o.set(c)),e.on(["scrub"],({scrub:c})=>l.set(c))),n.push(o.element,z("div",{class:"em-row em-scrub"},z("span",null,"before"),l.element,z("span",null,"after")),z("button",{type:"button",class:"em-button",onclick:t.blink,title:"Change between before and after (B)"},"Blink"))}let r=(o,a,l)=>z("button",{type:"button",class:"em-button",title:a,onclick:l},o);return n.push(z("span",{class:"em-row em-last"},r("Fit","Show the whole mesh (F)",t.fit),r("Save picture","Save the picture as PNG",t.save),r("Keys","List the keys (?)",t.keys))),{element:z("div",{class:"em-bar",role:"toolbar","aria-label":"View"},...n),dispose:()=>s.forEach(o=>o())}}function Vt(i,e=4){if(i===null||i===1/0)return"\u221E";if(i===void 0||Number.isNaN(i))return"\u2013";if(i===0)return"0";let t=Math.abs(i);if(t>=1e6||t<1e-4){let[s,r]=i.toExponential(e-2).split("e");return`${Number(s)}e${Number(r)}`.replaceAll("-","\u2212")}let n=Math.max(0,e-1-Math.floor(Math.log10(t)));return String(Number(i.toFixed(Math.min(n,6)))).replace("-","\u2212")}var eo=i=>i.toLocaleString("en-US"),Jn=i=>i.replaceAll("_"," "),Ds=(i,e)=>e?`${i}${e==="\xB0"?"":" "}${e}`:i;function Rp(i,e,t){let n=[...i.vertices.subarray(i.first[t],i.first[t+1])],s=e.flags[t];return{name:e.cellName(t),kind:ii[i.kind[t]].name,group:e.groupName(t),vertices:n.map(e.vertexName),held:e.hasHolds?OM(n.map(r=>e.hold[r])):null,flags:[s&1&&(s&2?"inverted before and after":"inverted before"),s&2&&!(s&1)&&"inverted after",s&4&&"wall layer"].filter(Boolean),inverted:!!(s&3),middle:i.toFile(Tr(i,i.after??i.before,t)),largestMove:i.after?Math.max(...n.map(r=>UM(i,r))):null}}function UM({before:i,after:e},t){return Math.hypot(...[0,1,2].map(n=>e[4*t+n]-i[4*t+n]))}function OM(i){return i.every(e=>e===0)?"all free":Ta.map((e,t)=>[i.filter(n=>n===t).length,e]).filter(([e])=>e>0).sort(([,e],[,t])=>(e==="free")-(t==="free")).map(([e,t])=>`${e} ${t}`).join(", ")}function Ip(i,e,t,n){let s=z("section",{class:"em-group em-cell","aria-live":"polite","aria-label":"Chosen cell"}),r=async({selected:a})=>{if(a<0){s.replaceChildren(z("h3",null,"Cell"),z("p",{class:"em-hint"},"Point at a cell to read it; click to keep it here."));return}let[l,...c]=await Promise.all([e.details(),...e.metrics.map(({name:f})=>e.metric(f))]);if(t.get().selected!==a)return;let h=i.worst?.find(({cell:f})=>f===a);s.replaceChildren(...BM(e,Rp(e,l,a),c,a,h,{close:()=>t.set({selected:-1}),goTo:()=>n(a)}))},o=t.on(["selected"],r);return{element:s,dispose:o}}function BM(i,e,t,n,s,{close:r,goTo:o}){let a=[e.group&&["group",e.group],e.held&&["vertices",e.held],s?.held_by?.length>0&&["held by",s.held_by.join("; ")],e.largestMove!==null&&["largest move",e.largestMove>0?Vt(e.largestMove):"none"],["middle",e.middle.slice(0,i.dimension).map(l=>Vt(l)).join(", ")],["vertex ids",e.vertices.join(", ")]].filter(Boolean);return[z("div",{class:"em-row em-spread"},z("h3",null,`${e.kind} ${e.name}`),z("span",{class:"em-row"},z("button",{type:"button",class:"em-button",onclick:o,title:"Bring it to the middle (G)"},"Go to"),z("button",{type:"button",class:"em-button",onclick:r,"aria-label":"Close",title:"Close (Esc)"},"\xD7"))),e.flags.length>0&&z("p",{class:"em-tags"},...e.flags.map(l=>z("span",{class:`em-tag ${l==="wall layer"?"em-calm":""}`},l))),z("table",{class:"em-table em-metrics"},i.after&&z("thead",null,z("tr",null,z("td"),z("th",{scope:"col",class:"em-number"},"before"),z("th",{scope:"col",class:"em-number"},"after"))),z("tbody",null,...t.map(l=>z("tr",null,z("th",{scope:"row"},Jn(l.name)),z("td",{class:"em-number"},oa(l,l.before[n])),i.after&&z("td",{class:"em-number"},oa(l,l.after[n])))))),z("dl",{class:"em-ledger"},...a.flatMap(([l,c])=>[z("dt",null,l),z("dd",null,c)]))].filter(Boolean)}function oa(i,e){if(e===255)return"undefined";let t=Ds(Vt(Ca(i,e),3),i.unit);return e===254&&i.better==="lower"?`\u2265 ${t}`:t}function Pp({command:i,run:e,program:t}){return z("section",{class:"em-card em-wide"},z("h2",null,"How it was made"),i&&z("div",{class:"em-command"},z("pre",{tabindex:"0","aria-label":"Command line"},i),hh("Copy command",()=>i)),e&&kM(e),t&&z("p",{class:"em-hint"},t))}function kM(i){let e=()=>JSON.stringify(i,null,2),t=z("pre",{class:"em-json",tabindex:"0","aria-label":"Record of the run"}),n=z("details",{ontoggle:()=>{n.open&&!t.textContent&&(t.textContent=e())}},z("summary",null,"Record of the run (JSON)"),hh("Copy JSON",e),t);return n}var zM=[[.2777273272234177,.1050930431085774,-.3308618287255563,-4.634230498983486,6.228269936347081,4.776384997670288,-5.435455855934631],[.005407344544966578,1.404613529898575,.214847559468213,-5.799100973351585,14.17993336680509,-13.74514537774601,4.645852612178535],[.3340998053353061,1.384590162594685,.09509516302823659,-19.33244095627987,56.69055260068105,-65.35303263337234,26.3124352495832]];function to(i){let e=Math.min(1,Math.max(0,i));return zM.map(t=>{let n=t.reduceRight((s,r)=>s*e+r,0);return Math.round(255*Math.min(1,Math.max(0,n)))})}var no=[226,26,108],Ic=[150,0,66],ns=([i,e,t])=>`rgb(${i}, ${e}, ${t})`;function Lp(){let i=new Uint8Array(1024);for(let e=0;e<256;++e)i.set([...to(e/255),255],4*e);return i}function aa(i,e){return i.better==="lower"?1-e/254:e/254}var is=320,Pc=132,oi={left:34,right:8,top:8,bottom:22},ir=(is-oi.left-oi.right)/53;function Fp(i){let e=qt("svg",{viewBox:`0 0 ${is} ${Pc}`,class:"em-histogram",role:"img"}),t=Dp("Least value shown",()=>f()),n=Dp("Greatest value shown",()=>f()),s=z("button",{type:"button",class:"em-button",onclick:()=>i.set({range:null})},"Reset"),r=ks("Values that the range applies to",[["before","before","Filter by the values before"],["after","after","Filter by the values after"]],d=>i.set({rangeOf:d})),o=z("output",{class:"em-hint em-count"}),a=z("div",null,e,z("div",{class:"em-row"},t,z("span",{"aria-hidden":"true"},"\u2013"),n,i.get().rangeOf==="after"?r.element:null),z("div",{class:"em-row em-spread"},o,s)),l,c=i.get().rangeOf==="after",h=()=>{let{values:d,range:g}=i.get();if(!d)return e.replaceChildren();VM(e,d,c),l=HM(e,d,g,M=>i.set({range:M}))};function f(){let{values:d}=i.get();if(!d)return;let g=A=>(A.valueAsNumber-d.low)/(d.high-d.low||1)*254,M=d.better==="lower"?0:-1,p=d.better==="lower"?255:254,m=Number.isNaN(t.valueAsNumber)||g(t)<=0?M:Math.ceil(g(t)-1e-6),y=Number.isNaN(n.valueAsNumber)||g(n)>=254?p:Math.floor(g(n)+1e-6);i.set({range:m<=M&&y>=p?null:[m,y]})}let u=[i.on(["values"],h),i.on(["range","values","rangeOf"],({range:d,rangeOf:g,values:M})=>{l?.show(d),s.disabled=!d,r.set(g);for(let[p,m]of[[t,0],[n,1]]){let y=d&&M&&d[m]>=0&&d[m]<=254;p.value=y?Number(Ca(M,d[m]).toPrecision(3)):"",M&&(p.placeholder=Vt(m===0?M.low:M.high,3))}}),i.on(["visible"],({visible:d})=>{o.textContent=d?`${eo(d.count)} of ${eo(d.of.length)} cells shown`:""})];return{element:a,dispose:()=>u.forEach(d=>d())}}function Dp(i,e){return z("input",{type:"number",step:"any",class:"em-range","aria-label":i,onchange:e})}function ca(i,e){let t=i.better==="lower"?0:2;return oi.left+ir*(e+t)}var Lc=i=>oi.left+(i.better==="lower"?ir*52:0);function VM(i,e,t){let n=dh(e.before),s=dh(e.after),r=Math.max(1,...n.bars,...s.bars,n.undefinedCount,s.undefinedCount),o=Math.log10(r+1),a=Pc-oi.bottom,l=h=>a-(a-oi.top)*Math.log10(h+1)/o,c=[];for(let h=1;h<=r;h*=10)c.push(qt("line",{x1:oi.left,x2:is-oi.right,y1:l(h),y2:l(h),class:"em-grid"}),qt("text",{x:oi.left-5,y:l(h)+3.5,class:"em-tick em-end"},GM(h)));if(s.bars.forEach((h,f)=>{h>0&&c.push(Np(ca(e,f),l(h),a,ns(to(aa(e,f*5+2)))))}),s.undefinedCount>0&&c.push(Np(Lc(e),l(s.undefinedCount),a,ns(no))),t){let h=n.bars.reduce((f,u,d)=>`${f}V${l(u)}h${ir}`,`M${ca(e,0)} ${a}`);c.push(qt("path",{d:`${h}V${a}`,class:"em-before-line"})),n.undefinedCount>0&&c.push(qt("path",{d:`M${Lc(e)} ${a}V${l(n.undefinedCount)}h${ir}V${a}`,class:"em-before-line"}))}c.push(qt("line",{x1:oi.left,x2:is-oi.right,y1:a,y2:a,class:"em-base"}));for(let[h,f,u]of[[e.low,0,"em-start"],[(e.low+e.high)/2,.5,"em-middle"],[e.high,1,"em-end"]])c.push(qt("text",{x:ca(e,f*51),y:Pc-7,class:`em-tick ${u}`},Ds(Vt(h,3),e.unit)));i.setAttribute("aria-label",`Number of cells by ${Jn(e.name)}, logarithmic${t?": before as a line, after as bars":""}. Drag to show a range only.`),i.replaceChildren(...c)}var Np=(i,e,t,n)=>qt("rect",{x:i+.4,y:e,width:ir-.8,height:t-e,fill:n}),GM=i=>i>=1e6?`${i/1e6}M`:i>=1e3?`${i/1e3}k`:i;function HM(i,e,t,n){let s=e.better==="lower",r=s?0:-1,o=s?255:254,a=Pc-oi.bottom,l=()=>qt("rect",{y:0,height:a,width:0,class:"em-shade"}),c=l(),h=l();i.append(c,h);let f=p=>{let m=i.getBoundingClientRect(),y=(p.clientX-m.left)/m.width*is;return Math.floor((y-ca(e,0))/ir)},u=(p,m)=>{let y=Math.min(p,m),A=Math.max(p,m),w=y<0?r:Math.min(y,50)*5,D=A>=51?o:Math.max(0,A)*5+5-1;return s&&y>=51?[255,255]:!s&&A<0?[-1,-1]:[w,Math.min(D,o)]},d=null;i.onpointerdown=p=>{i.setPointerCapture(p.pointerId),d={bar:f(p),x:p.clientX}},i.onpointermove=p=>{d&&Math.abs(p.clientX-d.x)>3&&n(u(d.bar,f(p)))},i.onpointerup=p=>{d&&Math.abs(p.clientX-d.x)<=3&&n(u(d.bar,d.bar)),d=null};let g=(p,m)=>p<0?m?Lc(e)+ir:0:p>254?m?is:Lc(e):ca(e,(p+(m?1:0))/5),M=p=>{let m=p?g(p[0],!1):0,y=p?p[1]===o?is:g(p[1],!0):is;c.setAttribute("width",Math.max(0,m)),h.setAttribute("x",y),h.setAttribute("width",Math.max(0,is-y))};return M(t),{show:M}}function Up(i,e,t){let n=[],s=(o,a)=>n.push(e.on(o,a));return{panels:[i.metrics.length>0&&WM(i,e,s,n),XM(i,e,s),i.dimension===3&&qM(e,s,t)].filter(Boolean),dispose:()=>n.forEach(o=>o())}}function WM(i,e,t,n){let s=wa("Metric",i.metrics.map(({name:o})=>[o,Jn(o)]),o=>e.set({metric:o,range:null}));t(["metric"],({metric:o})=>s.set(o));let r=Fp(e);return n.push(r.dispose),z("section",{class:"em-group","aria-label":"Colour"},z("div",{class:"em-row em-spread"},z("h3",null,"Colour by"),s.element),r.element)}function XM(i,e,t){let n=[["edges","Cell edges","Edges of cells (E)"],i.dimension===3&&["features","Shape edges","Boundary and feature edges (O)"],["marks","Held vertices","Vertices that are fixed, slide or were stopped (M)"]].filter(Boolean),s=([c,h,f])=>{let{button:u,set:d}=ch(h,f,()=>e.set({[c]:!e.get()[c]}));return t([c],g=>d(g[c])),u},r=wa("Cells to show",[["all","all cells"],["0.1","worst 10 %"],["0.01","worst 1 %"],["0.001","worst 0.1 %"],["listed","listed worst cells"]],c=>e.set({show:c})),o=ks("The other cells",[["fade","faded"],["hide","hidden"]],c=>e.set({others:c}));t(["show"],({show:c})=>r.set(c)),t(["others"],c=>o.set(c.others));let a=wa("Scale of the moves",[1,2,5,10,50].map(c=>[String(c),`\xD7 ${c}`]),c=>e.set({vectorScale:Number(c),vectors:!0}));t(["vectorScale"],({vectorScale:c})=>a.set(String(c)));let l=bo("Shrink cells",{min:.3,max:1,step:.01},c=>e.set({shrink:1.3-c}));return t(["shrink"],c=>l.set(1.3-c.shrink)),z("section",{class:"em-group","aria-label":"Show"},z("h3",null,"Show"),z("div",{class:"em-row"},...n.map(s)),i.after&&z("div",{class:"em-row"},z("span",{class:"em-what"},"Moves"),s(["vectors","Arrows","From where each vertex was to where it is (V)"]),a.element),z("div",{class:"em-row"},z("span",{class:"em-what"},"Cells"),r.element),i.type!=="volume"&&z("div",{class:"em-row"},z("span",{class:"em-what"},"Others"),o.element),z("label",{class:"em-row"},z("span",{class:"em-what"},"Shrink"),l.element))}function qM(i,e,t){let n=ks("Cut along",[["off","off"],["x","x"],["y","y"],["z","z"],["view","view","Along the line of sight as it is now"]],a=>t.cut(a)),s=bo("Place of the cut",{min:0,max:1,step:.005},a=>i.set({cutPlace:a})),r=ch("Flip","Keep the other side",()=>i.set({cutFlip:!i.get().cutFlip})),o=z("div",{class:"em-row"},s.element,r.button);return e(["cutAxis"],({cutAxis:a})=>{n.set(a),o.hidden=a==="off"}),e(["cutPlace"],({cutPlace:a})=>{s.set(a),s.element.setAttribute("aria-valuetext",`${Vt(100*a,3)} %`)}),e(["cutFlip"],({cutFlip:a})=>r.set(a)),z("section",{class:"em-group","aria-label":"Cut"},z("div",{class:"em-row em-spread"},z("h3",null,"Cut"),n.element),o)}var YM="uplot",$M="u-hz",ZM="u-vt",JM="u-title",KM="u-wrap",jM="u-under",QM="u-over",eb="u-axis",or="u-off",tb="u-select",nb="u-cursor-x",ib="u-cursor-y",sb="u-cursor-pt",rb="u-legend",ob="u-live",ab="u-inline",lb="u-series",cb="u-marker",Op="u-label",hb="u-value",ua="width",fa="height";var Bp="bottom",so="left",Nu="right",Ku="#000",kp=Ku+"0",Fu="mousemove",zp="mousedown",Uu="mouseup",Vp="mouseenter",Gp="mouseleave",Hp="dblclick",ub="resize",fb="scroll",Wp="change",Oc="dppxchange",ju="--",uo=typeof window<"u",Vu=uo?document:null,oo=uo?window:null,db=uo?navigator:null,bt,Dc;function Gu(){let i=devicePixelRatio;bt!=i&&(bt=i,Dc&&Wu(Wp,Dc,Gu),Dc=matchMedia(`(min-resolution: ${bt-.001}dppx) and (max-resolution: ${bt+.001}dppx)`),ar(Wp,Dc,Gu),oo.dispatchEvent(new CustomEvent(Oc)))}function Kn(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Hu(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Bt(i,e,t){i.style[e]=t+"px"}function _i(i,e,t,n){let s=Vu.createElement(i);return e!=null&&Kn(s,e),t?.insertBefore(s,n),s}function ai(i,e){return _i("div",i,e)}var Xp=new WeakMap;function Hi(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Xp.get(i);r!=o&&(i.style.transform=r,Xp.set(i,r),e<0||t<0||e>n||t>s?Kn(i,or):Hu(i,or))}var qp=new WeakMap;function Yp(i,e,t){let n=e+t,s=qp.get(i);n!=s&&(qp.set(i,n),i.style.background=e,i.style.borderColor=t)}var $p=new WeakMap;function Zp(i,e,t,n){let s=e+""+t,r=$p.get(i);s!=r&&($p.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Qu={passive:!0},pb={...Qu,capture:!0};function ar(i,e,t,n){e.addEventListener(i,t,n?pb:Qu)}function Wu(i,e,t,n){e.removeEventListener(i,t,Qu)}uo&&Gu();function xi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:jn((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Sm(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var wm=i=>i!=null,Am=i=>i!=null&&i>0,zc=Sm(wm),mb=Sm(Am);function gb(i,e,t,n=0,s=!1){let r=s?mb:zc,o=s?Am:wm;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??It,l??-It]}function Vc(i,e,t,n){let s=jp(i),r=jp(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?ss:Tm,a=s==1?jn:li,l=r==1?li:jn,c=a(o(on(i))),h=l(o(on(e))),f=ao(t,c),u=ao(t,h);return t==10&&(c<0&&(f=Pt(f,-c)),h<0&&(u=Pt(u,-h))),n||t==2?(i=f*s,e=u*r):(i=Im(i,f),e=Gc(e,u)),[i,e]}function ef(i,e,t,n){let s=Vc(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var tf=.1,Jp={mode:3,pad:tf},pa={pad:0,soft:null,mode:0},_b={min:pa,max:pa};function Bc(i,e,t,n){return Hc(t)?Kp(i,e,t):(pa.pad=t,pa.soft=n?0:null,pa.mode=n?3:0,Kp(i,e,_b))}function gt(i,e){return i??e}function xb(i,e,t){for(e=gt(e,0),t=gt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Kp(i,e,t){let n=t.min,s=t.max,r=gt(n.pad,0),o=gt(s.pad,0),a=gt(n.hard,-It),l=gt(s.hard,It),c=gt(n.soft,It),h=gt(s.soft,-It),f=gt(n.mode,0),u=gt(s.mode,0),d=e-i,g=ss(d),M=Ln(on(i),on(e)),p=ss(M),m=on(p-g);(d<1e-24||m>10)&&(d=0,(i==0||e==0)&&(d=1e-24,f==2&&c!=It&&(r=0),u==2&&h!=-It&&(o=0)));let y=d||M||1e3,A=ss(y),w=ao(10,jn(A)),D=y*(d==0?i==0?.1:1:r),R=Pt(Im(i-D,w/10),24),N=i>=c&&(f==1||f==3&&R<=c||f==2&&R>=c)?c:It,v=Ln(a,R<N&&i>=N?N:vi(N,R)),T=y*(d==0?e==0?.1:1:o),q=Pt(Gc(e+T,w/10),24),E=e<=h&&(u==1||u==3&&q>=h||u==2&&q<=h)?h:-It,G=vi(l,q>E&&e<=E?E:Ln(E,q));return v==G&&v==0&&(G=100),[v,G]}var vb=new Intl.NumberFormat(uo?db.language:"en-US"),nf=i=>vb.format(i),Qn=Math,Uc=Qn.PI,on=Qn.abs,jn=Qn.floor,rn=Qn.round,li=Qn.ceil,vi=Qn.min,Ln=Qn.max,ao=Qn.pow,jp=Qn.sign,ss=Qn.log10,Tm=Qn.log2,yb=(i,e=1)=>Qn.sinh(i)*e,Ou=(i,e=1)=>Qn.asinh(i/e),It=1/0;function Qp(i){return(ss((i^i>>31)-(i>>31))|0)+1}function Xu(i,e,t){return vi(Ln(i,e),t)}function Em(i){return typeof i=="function"}function at(i){return Em(i)?i:()=>i}var Mb=()=>{},Cm=i=>i,Rm=(i,e)=>e,bb=i=>null,em=i=>!0,tm=(i,e)=>i==e,Sb=/\.\d*?(?=9{6,}|0{6,})/gm,lr=i=>{if(Lm(i)||Fs.has(i))return i;let e=`${i}`,t=e.match(Sb);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${lr(s)}e${r}`}return Pt(i,n)};function sr(i,e){return lr(Pt(lr(i/e))*e)}function Gc(i,e){return lr(li(lr(i/e))*e)}function Im(i,e){return lr(jn(lr(i/e))*e)}function Pt(i,e=0){if(Lm(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return rn(n)/t}var Fs=new Map;function Pm(i){return((""+i).split(".")[1]||"").length}function ga(i,e,t,n){let s=[],r=n.map(Pm);for(let o=e;o<t;o++){let a=on(o),l=Pt(ao(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),u=i==10?h:Pt(h,f);s.push(u),Fs.set(u,f)}}return s}var ma={},sf=[],lo=[null,null],Ns=Array.isArray,Lm=Number.isInteger,wb=i=>i===void 0;function nm(i){return typeof i=="string"}function Hc(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function Ab(i){return i!=null&&typeof i=="object"}var Tb=Object.getPrototypeOf(Uint8Array),Dm="__proto__";function co(i,e=Hc){let t;if(Ns(i)){let n=i.find(s=>s!=null);if(Ns(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=co(i[s],e)}else t=i.slice()}else if(i instanceof Tb)t=i.slice();else if(e(i)){t={};for(let n in i)n!=Dm&&(t[n]=co(i[n],e))}else t=i;return t}function en(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=Dm&&(Hc(i[s])?en(i[s],co(n[s])):i[s]=co(n[s]))}return i}var Eb=0,Cb=1,Rb=2;function Ib(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function Pb(i,e){if(Nb(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return Fb(o[0])||(o=Db(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],f=Array(s).fill(void 0),u=e?e[o][c]:Cb,d=[];for(let g=0;g<h.length;g++){let M=h[g],p=r.get(l[g]);M===null?u!=Eb&&(f[p]=M,u==Rb&&d.push(p)):f[p]=M}Ib(f,d,s),n.push(f)}}return n}var Lb=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Db(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function Nb(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Fb(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Ln(1,jn((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Nm=["January","February","March","April","May","June","July","August","September","October","November","December"],Fm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Um(i){return i.slice(0,3)}var Ub=Fm.map(Um),Ob=Nm.map(Um),Bb={MMMM:Nm,MMM:Ob,WWWW:Fm,WWW:Ub};function ha(i){return(i<10?"0":"")+i}function kb(i){return(i<10?"00":i<100?"0":"")+i}var zb={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>ha(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>ha(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>ha(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>ha(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>ha(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>kb(i.getMilliseconds())};function rf(i,e){e=e||Bb;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?zb[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Vb=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Gb(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==Vb?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var Om=i=>i%1==0,kc=[1,2,2.5,5],Hb=ga(10,-32,0,kc),Bm=ga(10,0,32,kc),Wb=Bm.filter(Om),rr=Hb.concat(Bm),of=`
`,km="{YYYY}",im=of+km,zm="{M}/{D}",da=of+zm,Nc=da+"/{YY}",Vm="{aa}",Xb="{h}:{mm}",ro=Xb+Vm,sm=of+ro,rm=":{ss}",wt=null;function Gm(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?ga(10,0,3,kc).filter(Om):ga(10,-3,0,kc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,km,wt,wt,wt,wt,wt,wt,1],[s*28,"{MMM}",im,wt,wt,wt,wt,wt,1],[s,zm,im,wt,wt,wt,wt,wt,1],[n,"{h}"+Vm,Nc,wt,da,wt,wt,wt,1],[t,ro,Nc,wt,da,wt,wt,wt,1],[e,rm,Nc+" "+ro,wt,da+" "+ro,wt,sm,wt,1],[i,rm+".{fff}",Nc+" "+ro,wt,da+" "+ro,wt,sm,wt,1]];function h(f){return(u,d,g,M,p,m)=>{let y=[],A=p>=o,w=p>=r&&p<o,D=f(g),R=Pt(D*i,3),N=Bu(D.getFullYear(),A?0:D.getMonth(),w||A?1:D.getDate()),v=Pt(N*i,3);if(w||A){let T=w?p/r:0,q=A?p/o:0,E=R==v?R:Pt(Bu(N.getFullYear()+q,N.getMonth()+T,1)*i,3),G=new Date(rn(E/i)),O=G.getFullYear(),W=G.getMonth();for(let V=0;E<=M;V++){let H=Bu(O+q*V,W+T*V,1),U=H-f(Pt(H*i,3));E=Pt((+H+U)*i,3),E<=M&&y.push(E)}}else{let T=p>=s?s:p,q=jn(g)-jn(R),E=v+q+Gc(R-v,T);y.push(E);let G=f(E),O=G.getHours()+G.getMinutes()/t+G.getSeconds()/n,W=p/n,V=u.axes[d]._space,H=m/V;for(;E=Pt(E+p,i==1?0:3),!(E>M);)if(W>1){let U=jn(Pt(O+W,6))%24,ce=f(E).getHours()-U;ce>1&&(ce=-1),E-=ce*n,O=(O+W)%24;let _e=y[y.length-1];Pt((E-_e)/p,3)*H>=.7&&y.push(E)}else y.push(E)}return y}}return[l,c,h]}var[qb,Yb,$b]=Gm(1),[Zb,Jb,Kb]=Gm(.001);ga(2,-53,53,[1]);function om(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function am(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,f,u,d;return n.map(g=>{let M=i(g),p=M.getFullYear(),m=M.getMonth(),y=M.getDate(),A=M.getHours(),w=M.getMinutes(),D=M.getSeconds(),R=p!=l&&a[2]||m!=c&&a[3]||y!=h&&a[4]||A!=f&&a[5]||w!=u&&a[6]||D!=d&&a[7]||a[1];return l=p,c=m,h=y,f=A,u=w,d=D,R(M)})}}function jb(i,e){let t=rf(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Bu(i,e,t){return new Date(i,e,t)}function lm(i,e){return e(i)}var Qb="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function cm(i,e){return(t,n,s,r)=>r==null?ju:e(i(n))}function eS(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function tS(i,e){return i.series[e].fill(i,e)}var nS={show:!0,live:!0,isolate:!1,mount:Mb,markers:{show:!0,width:2,stroke:eS,fill:tS,dash:"solid"},idx:null,idxs:null,values:[]};function iS(i,e){let t=i.cursor.points,n=ai(),s=t.size(i,e);Bt(n,ua,s),Bt(n,fa,s);let r=s/-2;Bt(n,"marginLeft",r),Bt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Bt(n,"borderWidth",o),n}function sS(i,e){let t=i.series[e].points;return t._fill||t._stroke}function rS(i,e){let t=i.series[e].points;return t._stroke||t._fill}function oS(i,e){return i.series[e].points.size}var ku=[0,0];function aS(i,e,t){return ku[0]=e,ku[1]=t,ku}function Fc(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function zu(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var lS={show:!0,x:!0,y:!0,lock:!1,move:aS,points:{one:!1,show:iS,size:oS,width:0,stroke:rS,fill:sS},bind:{mousedown:Fc,mouseup:Fc,click:Fc,dblclick:Fc,mousemove:zu,mouseleave:zu,mouseenter:zu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Hm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},af=en({},Hm,{filter:Rm}),Wm=en({},af,{size:10}),Xm=en({},Hm,{show:!1}),lf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',qm="bold "+lf,Ym=1.5,hm={show:!0,scale:"x",stroke:Ku,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:qm,side:2,grid:af,ticks:Wm,border:Xm,font:lf,lineGap:Ym,rotate:0},cS="Value",hS="Time",um={show:!0,scale:"x",auto:!1,sorted:1,min:It,max:-It,idxs:[]};function uS(i,e,t,n,s){return e.map(r=>r==null?"":nf(r))}function fS(i,e,t,n,s,r,o){let a=[],l=Fs.get(s)||0;t=o?t:Pt(Gc(t,s),l);for(let c=t;c<=n;c=Pt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function qu(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?ss:Tm,h=jn(c(t));s=ao(l,h),l==10&&(s=rr[xi(s,rr)]);let f=t,u=s*l;l==10&&(u=rr[xi(u,rr)]);do a.push(f),f=f+s,l==10&&!Fs.has(f)&&(f=Pt(f,Fs.get(s))),f>=u&&(s=f,u=s*l,l==10&&(u=rr[xi(u,rr)]));while(f<=n);return a}function dS(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?qu(i,e,Ln(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?qu(i,e,Ln(l,-n),-t,s):[l]).reverse().map(u=>-u).concat(h,c)}var $m=/./,pS=/[12357]/,mS=/[125]/,fm=/1/,Yu=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function gS(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),f=l(9,o)-h>=c?$m:l(7,o)-h>=c?pS:l(5,o)-h>=c?mS:fm;if(f==fm){let u=on(l(1,o)-h);if(u<c)return Yu(e.slice().reverse(),a.distr,f,li(c/u)).reverse()}return Yu(e,a.distr,f,1)}function _S(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=on(l(1,o)-l(2,o));return c<a?Yu(e.slice().reverse(),3,$m,li(a/c)).reverse():e}function xS(i,e,t,n){return n==null?ju:e==null?"":nf(e)}var dm={show:!0,scale:"y",stroke:Ku,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:qm,side:3,grid:af,ticks:Wm,border:Xm,font:lf,lineGap:Ym,rotate:0};function vS(i,e){let t=3+(i||1)*2;return Pt(t*e,3)}function yS(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=on(o-r),l=i.series[e],c=a/(l.points.space*bt);return n[1]-n[0]<=c}var pm={scale:null,auto:!0,sorted:0,min:It,max:-It},Zm=(i,e,t,n,s)=>s,mm={show:!0,auto:!0,sorted:0,gaps:Zm,alpha:1,facets:[en({},pm,{scale:"x"}),en({},pm,{scale:"y"})]},gm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Zm,alpha:1,points:{show:yS,filter:null},values:null,min:It,max:-It,idxs:[],path:null,clip:null};function MS(i,e,t,n,s){return t/10}var Jm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},bS=en({},Jm,{time:!1,ori:1}),_m={};function Km(i,e){let t=_m[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(_m[i]=t)),t}var ho=1,$u=2;function cr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],f=n==2?o[s.facets[1].scale]:o[s.scale],u=a.left,d=a.top,g=a.width,M=a.height,p=i.valToPosH,m=i.valToPosV;return h.ori==0?t(s,l,c,h,f,p,m,u,d,g,M,Xc,fo,Yc,Qm,tg):t(s,l,c,h,f,m,p,d,u,M,g,qc,po,uf,eg,ng)}function cf(i,e){let t=0,n=0,s=gt(i.bands,sf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function SS(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function rs(i,e,t,n,s,r){return cr(i,e,(o,a,l,c,h,f,u,d,g,M,p)=>{let m=o.pxRound,y=c.dir*(c.ori==0?1:-1),A=c.ori==0?fo:po,w,D;y==1?(w=t,D=n):(w=n,D=t);let R=m(f(a[w],c,M,d)),N=m(u(l[w],h,p,g)),v=m(f(a[D],c,M,d)),T=m(u(r==1?h.max:h.min,h,p,g)),q=new Path2D(s);return A(q,v,T),A(q,R,T),A(q,R,N),q})}function Wc(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Yc:uf,l=t;for(let f=0;f<i.length;f++){let u=i[f];if(u[1]>u[0]){let d=u[0]-l;d>0&&a(o,l,n,d,n+r),l=u[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function wS(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function hf(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let f=c,u=c;if(s==1)for(;++c<=n&&e[c]===null;)u=c;else for(;--c>=t&&e[c]===null;)u=c;let d=r(i[f]),g=u==f?d:r(i[u]),M=f-s;d=o<=0&&M>=0&&M<l?r(i[M]):d;let m=u+s;g=o>=0&&m>=0&&m<l?r(i[m]):g,g>=d&&a.push([d,g])}return a}function xm(i){return i==0?Cm:i==1?rn:e=>sr(e,i)}function jm(i){let e=i==0?Xc:qc,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=vi(c,a/2,l/2),h=vi(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var Xc=(i,e,t)=>{i.moveTo(e,t)},qc=(i,e,t)=>{i.moveTo(t,e)},fo=(i,e,t)=>{i.lineTo(e,t)},po=(i,e,t)=>{i.lineTo(t,e)},Yc=jm(0),uf=jm(1),Qm=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},eg=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},tg=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},ng=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function ig(i){return(e,t,n,s,r)=>cr(e,t,(o,a,l,c,h,f,u,d,g,M,p)=>{let{pxRound:m,points:y}=o,A,w;c.ori==0?(A=Xc,w=Qm):(A=qc,w=eg);let D=Pt(y.width*bt,3),R=(y.size-y.width)/2*bt,N=Pt(R*2,3),v=new Path2D,T=new Path2D,{left:q,top:E,width:G,height:O}=e.bbox;Yc(T,q-N,E-N,G+N*2,O+N*2);let W=V=>{if(l[V]!=null){let H=m(f(a[V],c,M,d)),U=m(u(l[V],h,p,g));A(v,H+R,U),w(v,H,U,R,0,Uc*2)}};if(r)r.forEach(W);else for(let V=n;V<=s;V++)W(V);return{stroke:D>0?v:null,fill:v,clip:T,flags:ho|$u}})}function sg(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var AS=sg(fo),TS=sg(po);function rg(i){let e=gt(i?.alignGaps,0);return(t,n,s,r)=>cr(t,n,(o,a,l,c,h,f,u,d,g,M,p)=>{[s,r]=zc(l,s,r);let m=o.pxRound,y=O=>m(f(O,c,M,d)),A=O=>m(u(O,h,p,g)),w,D;c.ori==0?(w=fo,D=AS):(w=po,D=TS);let R=c.dir*(c.ori==0?1:-1),N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ho},v=N.stroke,T=!1;if(r-s>=M*4){let O=ue=>t.posToVal(ue,c.key,!0),W=null,V=null,H,U,le,ie=y(a[R==1?s:r]),ce=y(a[s]),_e=y(a[r]),oe=O(R==1?ce+1:_e-1);for(let ue=R==1?s:r;ue>=s&&ue<=r;ue+=R){let et=a[ue],Q=(R==1?et<oe:et>oe)?ie:y(et),re=l[ue];Q==ie?re!=null?(U=re,W==null?(w(v,Q,A(U)),H=W=V=U):U<W?W=U:U>V&&(V=U)):re===null&&(T=!0):(W!=null&&D(v,ie,A(W),A(V),A(H),A(U)),re!=null?(U=re,w(v,Q,A(U)),W=V=H=U):(W=V=null,re===null&&(T=!0)),ie=Q,oe=O(ie+R))}W!=null&&W!=V&&le!=ie&&D(v,ie,A(W),A(V),A(H),A(U))}else for(let O=R==1?s:r;O>=s&&O<=r;O+=R){let W=l[O];W===null?T=!0:W!=null&&w(v,y(a[O]),A(W))}let[E,G]=cf(t,n);if(o.fill!=null||E!=0){let O=N.fill=new Path2D(v),W=o.fillTo(t,n,o.min,o.max,E),V=A(W),H=y(a[s]),U=y(a[r]);R==-1&&([U,H]=[H,U]),w(O,U,V),w(O,H,V)}if(!o.spanGaps){let O=[];T&&O.push(...hf(a,l,s,r,R,y,e)),N.gaps=O=o.gaps(t,n,s,r,O),N.clip=Wc(O,c.ori,d,g,M,p)}return G!=0&&(N.band=G==2?[rs(t,n,s,r,v,-1),rs(t,n,s,r,v,1)]:rs(t,n,s,r,v,G)),N})}function ES(i){let e=gt(i.align,1),t=gt(i.ascDesc,!1),n=gt(i.alignGaps,0),s=gt(i.extend,!1);return(r,o,a,l)=>cr(r,o,(c,h,f,u,d,g,M,p,m,y,A)=>{[a,l]=zc(f,a,l);let w=c.pxRound,{left:D,width:R}=r.bbox,N=ce=>w(g(ce,u,y,p)),v=ce=>w(M(ce,d,A,m)),T=u.ori==0?fo:po,q={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ho},E=q.stroke,G=u.dir*(u.ori==0?1:-1),O=v(f[G==1?a:l]),W=N(h[G==1?a:l]),V=W,H=W;s&&e==-1&&(H=D,T(E,H,O)),T(E,W,O);for(let ce=G==1?a:l;ce>=a&&ce<=l;ce+=G){let _e=f[ce];if(_e==null)continue;let oe=N(h[ce]),ue=v(_e);e==1?T(E,oe,O):T(E,V,ue),T(E,oe,ue),O=ue,V=oe}let U=V;s&&e==1&&(U=D+R,T(E,U,O));let[le,ie]=cf(r,o);if(c.fill!=null||le!=0){let ce=q.fill=new Path2D(E),_e=c.fillTo(r,o,c.min,c.max,le),oe=v(_e);T(ce,U,oe),T(ce,H,oe)}if(!c.spanGaps){let ce=[];ce.push(...hf(h,f,a,l,G,N,n));let _e=c.width*bt/2,oe=t||e==1?_e:-_e,ue=t||e==-1?-_e:_e;ce.forEach(et=>{et[0]+=oe,et[1]+=ue}),q.gaps=ce=c.gaps(r,o,a,l,ce),q.clip=Wc(ce,u.ori,p,m,y,A)}return ie!=0&&(q.band=ie==2?[rs(r,o,a,l,E,-1),rs(r,o,a,l,E,1)]:rs(r,o,a,l,E,ie)),q})}function vm(i,e,t,n,s,r,o=It){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=on(i[l]-i[a]);h<c&&(c=h,o=on(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function CS(i){i=i||ma;let e=gt(i.size,[.6,It,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=at(s),o=1-e[0],a=gt(e[1],It),l=gt(e[2],1),c=gt(i.disp,ma),h=gt(i.each,d=>{}),{fill:f,stroke:u}=c;return(d,g,M,p)=>cr(d,g,(m,y,A,w,D,R,N,v,T,q,E)=>{let G=m.pxRound,O=t,W=n*bt,V=a*bt,H=l*bt,U,le;w.ori==0?[U,le]=r(d,g):[le,U]=r(d,g);let ie=w.dir*(w.ori==0?1:-1),ce=w.ori==0?Yc:uf,_e=w.ori==0?h:(L,K,ne,ee,Pe,ge,Oe)=>{h(L,K,ne,Pe,ee,Oe,ge)},oe=gt(d.bands,sf).find(L=>L.series[0]==g),ue=oe!=null?oe.dir:0,et=m.fillTo(d,g,m.min,m.max,ue),it=G(N(et,D,E,T)),Q,re,me,He=q,Se=G(m.width*bt),Ge=!1,At=null,Ye=null,rt=null,ht=null;f!=null&&(Se==0||u!=null)&&(Ge=!0,At=f.values(d,g,M,p),Ye=new Map,new Set(At).forEach(L=>{L!=null&&Ye.set(L,new Path2D)}),Se>0&&(rt=u.values(d,g,M,p),ht=new Map,new Set(rt).forEach(L=>{L!=null&&ht.set(L,new Path2D)})));let{x0:$e,size:Rt}=c;if($e!=null&&Rt!=null){O=1,y=$e.values(d,g,M,p),$e.unit==2&&(y=y.map(ne=>d.posToVal(v+ne*q,w.key,!0)));let L=Rt.values(d,g,M,p);Rt.unit==2?re=L[0]*q:re=R(L[0],w,q,v)-R(0,w,q,v),He=vm(y,A,R,w,q,v,He),me=He-re+W}else He=vm(y,A,R,w,q,v,He),me=He*o+W,re=He-me;me<1&&(me=0),Se>=re/2&&(Se=0),me<5&&(G=Cm);let F=me>0,Tt=He-me-(F?Se:0);re=G(Xu(Tt,H,V)),Q=(O==0?re/2:O==ie?0:re)-O*ie*((O==0?W/2:0)+(F?Se/2:0));let Ze={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},dt=Ge?null:new Path2D,Ie=null;if(oe!=null)Ie=d.data[oe.series[1]];else{let{y0:L,y1:K}=c;L!=null&&K!=null&&(A=K.values(d,g,M,p),Ie=L.values(d,g,M,p))}let I=U*re,x=le*re;for(let L=ie==1?M:p;L>=M&&L<=p;L+=ie){let K=A[L];if(K==null)continue;if(Ie!=null){let he=Ie[L]??0;if(K-he==0)continue;it=N(he,D,E,T)}let ne=w.distr!=2||c!=null?y[L]:L,ee=R(ne,w,q,v),Pe=N(gt(K,et),D,E,T),ge=G(ee-Q),Oe=G(Ln(Pe,it)),Be=G(vi(Pe,it)),ae=Oe-Be;if(K!=null){let he=K<0?x:I,we=K<0?I:x;Ge?(Se>0&&rt[L]!=null&&ce(ht.get(rt[L]),ge,Be+jn(Se/2),re,Ln(0,ae-Se),he,we),At[L]!=null&&ce(Ye.get(At[L]),ge,Be+jn(Se/2),re,Ln(0,ae-Se),he,we)):ce(dt,ge,Be+jn(Se/2),re,Ln(0,ae-Se),he,we),_e(d,g,L,ge-Se/2,Be,re+Se,ae)}}return Se>0?Ze.stroke=Ge?ht:dt:Ge||(Ze._fill=m.width==0?m._fill:m._stroke??m._fill,Ze.width=0),Ze.fill=Ge?Ye:dt,Ze})}function RS(i,e){let t=gt(e?.alignGaps,0);return(n,s,r,o)=>cr(n,s,(a,l,c,h,f,u,d,g,M,p,m)=>{[r,o]=zc(c,r,o);let y=a.pxRound,A=U=>y(u(U,h,p,g)),w=U=>y(d(U,f,m,M)),D,R,N;h.ori==0?(D=Xc,N=fo,R=tg):(D=qc,N=po,R=ng);let v=h.dir*(h.ori==0?1:-1),T=A(l[v==1?r:o]),q=T,E=[],G=[];for(let U=v==1?r:o;U>=r&&U<=o;U+=v)if(c[U]!=null){let ie=l[U],ce=A(ie);E.push(q=ce),G.push(w(c[U]))}let O={stroke:i(E,G,D,N,R,y),fill:null,clip:null,band:null,gaps:null,flags:ho},W=O.stroke,[V,H]=cf(n,s);if(a.fill!=null||V!=0){let U=O.fill=new Path2D(W),le=a.fillTo(n,s,a.min,a.max,V),ie=w(le);N(U,q,ie),N(U,T,ie)}if(!a.spanGaps){let U=[];U.push(...hf(l,c,r,o,v,A,t)),O.gaps=U=a.gaps(n,s,r,o,U),O.clip=Wc(U,h.ori,g,M,p,m)}return H!=0&&(O.band=H==2?[rs(n,s,r,o,W,-1),rs(n,s,r,o,W,1)]:rs(n,s,r,o,W,H)),O})}function IS(i){return RS(PS,i)}function PS(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),f=Array(o-1);for(let u=0;u<o-1;u++)h[u]=e[u+1]-e[u],f[u]=i[u+1]-i[u],c[u]=h[u]/f[u];l[0]=c[0];for(let u=1;u<o-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(f[u-1]+f[u])/((2*f[u]+f[u-1])/c[u-1]+(f[u]+2*f[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[o-1]=c[o-2];for(let u=0;u<o-1;u++)s(a,i[u]+f[u]/3,e[u]+l[u]*f[u]/3,i[u+1]-f[u]/3,e[u+1]-l[u+1]*f[u]/3,i[u+1],e[u+1])}return a}var Zu=new Set;function ym(){for(let i of Zu)i.syncRect(!0)}uo&&(ar(ub,oo,ym),ar(fb,oo,ym,!0),ar(Oc,oo,()=>{xn.pxRatio=bt}));var LS=rg(),DS=ig();function Mm(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Ju(r,o,e,t))}function NS(i,e){return i.map((t,n)=>n==0?{}:en({},e,t))}function Ju(i,e,t,n){return en({},e==0?t:n,i)}function og(i,e,t){return e==null?lo:[e,t]}var FS=og;function US(i,e,t){return e==null?lo:Bc(e,t,tf,!0)}function ag(i,e,t,n){return e==null?lo:Vc(e,t,i.scales[n].log,!1)}var OS=ag;function lg(i,e,t,n){return e==null?lo:ef(e,t,i.scales[n].log,!1)}var BS=lg;function kS(i,e,t,n,s){let r=Ln(Qp(i),Qp(e)),o=e-i,a=xi(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Fs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function bm(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=rn((t=+s)*bt))+"px"),[i,e,t]}function zS(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Pt(e[2]*bt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function xn(i,e,t){let n={mode:gt(i.mode,1)},s=n.mode;function r(_,b,C,P){let k=b.valToPct(_);return P+C*(b.dir==-1?1-k:k)}function o(_,b,C,P){let k=b.valToPct(_);return P+C*(b.dir==-1?k:1-k)}function a(_,b,C,P){return b.ori==0?r(_,b,C,P):o(_,b,C,P)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=ai(YM);if(i.id!=null&&(c.id=i.id),Kn(c,i.class),i.title){let _=ai(JM,c);_.textContent=i.title}let h=_i("canvas"),f=n.ctx=h.getContext("2d"),u=ai(KM,c);ar("click",u,_=>{_.target===g&&(Nt!=yr||zt!=Mr)&&pn.click(n,_)},!0);let d=n.under=ai(jM,u);u.appendChild(h);let g=n.over=ai(QM,u);i=co(i);let M=+gt(i.pxAlign,1),p=xm(M);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let m=i.ms||.001,y=n.series=s==1?Mm(i.series||[],um,gm,!1):NS(i.series||[null],mm),A=n.axes=Mm(i.axes||[],hm,dm,!0),w=n.scales={},D=n.bands=i.bands||[];D.forEach(_=>{_.fill=at(_.fill||null),_.dir=gt(_.dir,-1)});let R=s==2?y[1].facets[0].scale:y[0].scale,N={axes:ya,series:An},v=(i.drawOrder||["axes","series"]).map(_=>N[_]);function T(_){let b=_.distr==3?C=>ss(C>0?C:_.clamp(n,C,_.min,_.max,_.key)):_.distr==4?C=>Ou(C,_.asinh):_.distr==100?C=>_.fwd(C):C=>C;return C=>{let P=b(C),{_min:k,_max:$}=_,se=$-k;return(P-k)/se}}function q(_){let b=w[_];if(b==null){let C=(i.scales||ma)[_]||ma;if(C.from!=null){q(C.from);let P=en({},w[C.from],C,{key:_});P.valToPct=T(P),w[_]=P}else{b=w[_]=en({},_==R?Jm:bS,C),b.key=_;let P=b.time,k=b.range,$=Ns(k);if((_!=R||s==2&&!P)&&($&&(k[0]==null||k[1]==null)&&(k={min:k[0]==null?Jp:{mode:1,hard:k[0],soft:k[0]},max:k[1]==null?Jp:{mode:1,hard:k[1],soft:k[1]}},$=!1),!$&&Hc(k))){let se=k;k=(de,xe,Te)=>xe==null?lo:Bc(xe,Te,se)}b.range=at(k||(P?FS:_==R?b.distr==3?OS:b.distr==4?BS:og:b.distr==3?ag:b.distr==4?lg:US)),b.auto=at($?!1:b.auto),b.clamp=at(b.clamp||MS),b._min=b._max=null,b.valToPct=T(b)}}}q("x"),q("y"),s==1&&y.forEach(_=>{q(_.scale)}),A.forEach(_=>{q(_.scale)});for(let _ in i.scales)q(_);let E=w[R],G=E.distr,O,W;E.ori==0?(Kn(c,$M),O=r,W=o):(Kn(c,ZM),O=o,W=r);let V={};for(let _ in w){let b=w[_];(b.min!=null||b.max!=null)&&(V[_]={min:b.min,max:b.max},b.min=b.max=null)}let H=i.tzDate||(_=>new Date(rn(_/m))),U=i.fmtDate||rf,le=m==1?$b(H):Kb(H),ie=am(H,om(m==1?Yb:Jb,U)),ce=cm(H,lm(Qb,U)),_e=[],oe=n.legend=en({},nS,i.legend),ue=n.cursor=en({},lS,{drag:{y:s==2}},i.cursor),et=oe.show,it=ue.show,Q=oe.markers;oe.idxs=_e,Q.width=at(Q.width),Q.dash=at(Q.dash),Q.stroke=at(Q.stroke),Q.fill=at(Q.fill);let re,me,He,Se=[],Ge=[],At,Ye=!1,rt={};if(oe.live){let _=y[1]?y[1].values:null;Ye=_!=null,At=Ye?_(n,1,0):{_:0};for(let b in At)rt[b]=ju}if(et)if(re=_i("table",rb,c),He=_i("tbody",null,re),oe.mount(n,re),Ye){me=_i("thead",null,re,He);let _=_i("tr",null,me);_i("th",null,_);for(var ht in At)_i("th",Op,_).textContent=ht}else Kn(re,ab),oe.live&&Kn(re,ob);let $e={show:!0},Rt={show:!1};function F(_,b){if(b==0&&(Ye||!oe.live||s==2))return lo;let C=[],P=_i("tr",lb,He,He.childNodes[b]);Kn(P,_.class),_.show||Kn(P,or);let k=_i("th",null,P);if(Q.show){let de=ai(cb,k);if(b>0){let xe=Q.width(n,b);xe&&(de.style.border=xe+"px "+Q.dash(n,b)+" "+Q.stroke(n,b)),de.style.background=Q.fill(n,b)}}let $=ai(Op,k);_.label instanceof HTMLElement?$.appendChild(_.label):$.textContent=_.label,b>0&&(Q.show||($.style.color=_.width>0?Q.stroke(n,b):Q.fill(n,b)),Ze("click",k,de=>{if(ue._lock)return;dn(de);let xe=y.indexOf(_);if((de.ctrlKey||de.metaKey)!=oe.isolate){let Te=y.some((Re,De)=>De>0&&De!=xe&&Re.show);y.forEach((Re,De)=>{De>0&&Ci(De,Te?De==xe?$e:Rt:$e,!0,Kt.setSeries)})}else Ci(xe,{show:!_.show},!0,Kt.setSeries)},!1),Mi&&Ze(Vp,k,de=>{ue._lock||(dn(de),Ci(y.indexOf(_),Sr,!0,Kt.setSeries))},!1));for(var se in At){let de=_i("td",hb,P);de.textContent="--",C.push(de)}return[P,C]}let Tt=new Map;function Ze(_,b,C,P=!0){let k=Tt.get(b)||{},$=ue.bind[_](n,b,C,P);$&&(ar(_,b,k[_]=$),Tt.set(b,k))}function dt(_,b,C){let P=Tt.get(b)||{};for(let k in P)(_==null||k==_)&&(Wu(k,b,P[k]),delete P[k]);_==null&&Tt.delete(b)}let Ie=0,I=0,x=0,L=0,K=0,ne=0,ee=K,Pe=ne,ge=x,Oe=L,Be=0,ae=0,he=0,we=0;n.bbox={};let Ne=!1,Ae=!1,Je=!1,B=!1,ve=!1,fe=!1;function Le(_,b,C){(C||_!=n.width||b!=n.height)&&pe(_,b),gr(!1),Je=!0,Ae=!0,_r()}function pe(_,b){n.width=Ie=x=_,n.height=I=L=b,K=ne=0,Et(),_t();let C=n.bbox;Be=C.left=sr(K*bt,.5),ae=C.top=sr(ne*bt,.5),he=C.width=sr(x*bt,.5),we=C.height=sr(L*bt,.5)}let te=3;function Ue(){let _=!1,b=0;for(;!_;){b++;let C=Ei(b),P=ls(b);_=b==te||C&&P,_||(pe(n.width,n.height),Ae=!0)}}function Ke({width:_,height:b}){Le(_,b)}n.setSize=Ke;function Et(){let _=!1,b=!1,C=!1,P=!1;A.forEach((k,$)=>{if(k.show&&k._show){let{side:se,_size:de}=k,xe=se%2,Te=k.label!=null?k.labelSize:0,Re=de+Te;Re>0&&(xe?(x-=Re,se==3?(K+=Re,P=!0):C=!0):(L-=Re,se==0?(ne+=Re,_=!0):b=!0))}}),bi[0]=_,bi[1]=C,bi[2]=b,bi[3]=P,x-=Si[1]+Si[3],K+=Si[3],L-=Si[2]+Si[0],ne+=Si[0]}function _t(){let _=K+x,b=ne+L,C=K,P=ne;function k($,se){switch($){case 1:return _+=se,_-se;case 2:return b+=se,b-se;case 3:return C-=se,C+se;case 0:return P-=se,P+se}}A.forEach(($,se)=>{if($.show&&$._show){let de=$.side;$._pos=k(de,$._size),$.label!=null&&($._lpos=k(de,$.labelSize))}})}if(ue.dataIdx==null){let _=ue.hover,b=_.skip=new Set(_.skip??[]);b.add(void 0);let C=_.prox=at(_.prox),P=_.bias??=0;ue.dataIdx=(k,$,se,de)=>{if($==0)return se;let xe=se,Te=C(k,$,se,de)??It,Re=Te>=0&&Te<It,De=E.ori==0?x:L,Qe=ue.left,yt=e[0],mt=e[$];if(b.has(mt[se])){xe=null;let ot=null,We=null,Ve;if(P==0||P==-1)for(Ve=se;ot==null&&Ve-- >0;)b.has(mt[Ve])||(ot=Ve);if(P==0||P==1)for(Ve=se;We==null&&Ve++<mt.length;)b.has(mt[Ve])||(We=Ve);if(ot!=null||We!=null)if(Re){let Ut=ot==null?-1/0:O(yt[ot],E,De,0),Wt=We==null?1/0:O(yt[We],E,De,0),un=Qe-Ut,Ct=Wt-Qe;un<=Ct?un<=Te&&(xe=ot):Ct<=Te&&(xe=We)}else xe=We==null?ot:ot==null?We:se-ot<=We-se?ot:We}else Re&&on(Qe-O(yt[se],E,De,0))>Te&&(xe=null);return xe}}let dn=_=>{ue.event=_};ue.idxs=_e,ue._lock=!1;let Lt=ue.points;Lt.show=at(Lt.show),Lt.size=at(Lt.size),Lt.stroke=at(Lt.stroke),Lt.width=at(Lt.width),Lt.fill=at(Lt.fill);let Bn=n.focus=en({},i.focus||{alpha:.3},ue.focus),Mi=Bn.prox>=0,os=Mi&&Lt.one,wn=[],Wi=[],Dn=[];function fr(_,b){let C=Lt.show(n,b);if(C instanceof HTMLElement)return Kn(C,sb),Kn(C,_.class),Hi(C,-10,-10,x,L),g.insertBefore(C,wn[b]),C}function mo(_,b){if(s==1||b>0){let C=s==1&&w[_.scale].time,P=_.value;_.value=C?nm(P)?cm(H,lm(P,U)):P||ce:P||xS,_.label=_.label||(C?hS:cS)}if(os||b>0){_.width=_.width==null?1:_.width,_.paths=_.paths||LS||bb,_.fillTo=at(_.fillTo||SS),_.pxAlign=+gt(_.pxAlign,M),_.pxRound=xm(_.pxAlign),_.stroke=at(_.stroke||null),_.fill=at(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let C=vS(Ln(1,_.width),1),P=_.points=en({},{size:C,width:Ln(1,C*.2),stroke:_.stroke,space:C*2,paths:DS,_stroke:null,_fill:null},_.points);P.show=at(P.show),P.filter=at(P.filter),P.fill=at(P.fill),P.stroke=at(P.stroke),P.paths=at(P.paths),P.pxAlign=_.pxAlign}if(et){let C=F(_,b);Se.splice(b,0,C[0]),Ge.splice(b,0,C[1]),oe.values.push(null)}if(it){_e.splice(b,0,null);let C=null;os?b==0&&(C=fr(_,b)):b>0&&(C=fr(_,b)),wn.splice(b,0,C),Wi.splice(b,0,0),Dn.splice(b,0,0)}hn("addSeries",b)}function va(_,b){b=b??y.length,_=s==1?Ju(_,b,um,gm):Ju(_,b,{},mm),y.splice(b,0,_),mo(y[b],b)}n.addSeries=va;function dr(_){if(y.splice(_,1),et){oe.values.splice(_,1),Ge.splice(_,1);let b=Se.splice(_,1)[0];dt(null,b.firstChild),b.remove()}it&&(_e.splice(_,1),wn.splice(_,1)[0].remove(),Wi.splice(_,1),Dn.splice(_,1)),hn("delSeries",_)}n.delSeries=dr;let bi=[!1,!1,!1,!1];function pr(_,b){if(_._show=_.show,_.show){let C=_.side%2,P=w[_.scale];P==null&&(_.scale=C?y[1].scale:R,P=w[_.scale]);let k=P.time;_.size=at(_.size),_.space=at(_.space),_.rotate=at(_.rotate),Ns(_.incrs)&&_.incrs.forEach(se=>{!Fs.has(se)&&Fs.set(se,Pm(se))}),_.incrs=at(_.incrs||(P.distr==2?Wb:k?m==1?qb:Zb:rr)),_.splits=at(_.splits||(k&&P.distr==1?le:P.distr==3?qu:P.distr==4?dS:fS)),_.stroke=at(_.stroke),_.grid.stroke=at(_.grid.stroke),_.ticks.stroke=at(_.ticks.stroke),_.border.stroke=at(_.border.stroke);let $=_.values;_.values=Ns($)&&!Ns($[0])?at($):k?Ns($)?am(H,om($,U)):nm($)?jb(H,$):$||ie:$||uS,_.filter=at(_.filter||(P.distr>=3&&P.log==10?gS:P.distr==3&&P.log==2?_S:Rm)),_.font=bm(_.font),_.labelFont=bm(_.labelFont),_._size=_.size(n,null,b,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(bi[b]=!0,_._el=ai(eb,u))}}function as(_,b,C,P){let[k,$,se,de]=C,xe=b%2,Te=0;return xe==0&&(de||$)&&(Te=b==0&&!k||b==2&&!se?rn(hm.size/3):0),xe==1&&(k||se)&&(Te=b==1&&!$||b==3&&!de?rn(dm.size/2):0),Te}let go=n.padding=(i.padding||[as,as,as,as]).map(_=>at(gt(_,as))),Si=n._padding=go.map((_,b)=>_(n,b,bi,0)),tn,Zt=null,Jt=null,mr=s==1?y[0].idxs:null,kn=null,S=!1;function X(_,b){if(e=_??[],n.data=n._data=e,s==2){tn=0;for(let C=1;C<y.length;C++)tn+=e[C][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),kn=e[0],tn=kn.length;let C=e;if(G==2){C=e.slice();let P=C[0]=Array(tn);for(let k=0;k<tn;k++)P[k]=k}n._data=e=C}if(gr(!0),hn("setData"),G==2&&(Je=!0),b!==!1){let C=E;C.auto(n,S)?j():hs(R,C.min,C.max),B=B||ue.left>=0,fe=!0,_r()}}n.setData=X;function j(){S=!0;let _,b;s==1&&(tn>0?(Zt=mr[0]=0,Jt=mr[1]=tn-1,_=e[0][Zt],b=e[0][Jt],G==2?(_=Zt,b=Jt):_==b&&(G==3?[_,b]=Vc(_,_,E.log,!1):G==4?[_,b]=ef(_,_,E.log,!1):E.time?b=_+rn(86400/m):[_,b]=Bc(_,b,tf,!0))):(Zt=mr[0]=_=null,Jt=mr[1]=b=null)),hs(R,_,b)}let J,Y,ye,Ce,Me,Fe,ke,je,tt,Ee;function xt(_,b,C,P,k,$){_??=kp,C??=sf,P??="butt",k??=kp,$??="round",_!=J&&(f.strokeStyle=J=_),k!=Y&&(f.fillStyle=Y=k),b!=ye&&(f.lineWidth=ye=b),$!=Me&&(f.lineJoin=Me=$),P!=Fe&&(f.lineCap=Fe=P),C!=Ce&&f.setLineDash(Ce=C)}function kt(_,b,C,P){b!=Y&&(f.fillStyle=Y=b),_!=ke&&(f.font=ke=_),C!=je&&(f.textAlign=je=C),P!=tt&&(f.textBaseline=tt=P)}function Dt(_,b,C,P,k=0){if(P.length>0&&_.auto(n,S)&&(b==null||b.min==null)){let $=gt(Zt,0),se=gt(Jt,P.length-1),de=C.min==null?gb(P,$,se,k,_.distr==3):[C.min,C.max];_.min=vi(_.min,C.min=de[0]),_.max=Ln(_.max,C.max=de[1])}}let vt={min:null,max:null};function an(){for(let P in w){let k=w[P];V[P]==null&&(k.min==null||V[R]!=null&&k.auto(n,S))&&(V[P]=vt)}for(let P in w){let k=w[P];V[P]==null&&k.from!=null&&V[k.from]!=null&&(V[P]=vt)}V[R]!=null&&gr(!0);let _={};for(let P in V){let k=V[P];if(k!=null){let $=_[P]=co(w[P],Ab);if(k.min!=null)en($,k);else if(P!=R||s==2)if(tn==0&&$.from==null){let se=$.range(n,null,null,P);$.min=se[0],$.max=se[1]}else $.min=It,$.max=-It}}if(tn>0){y.forEach((P,k)=>{if(s==1){let $=P.scale,se=V[$];if(se==null)return;let de=_[$];if(k==0){let xe=de.range(n,de.min,de.max,$);de.min=xe[0],de.max=xe[1],Zt=xi(de.min,e[0]),Jt=xi(de.max,e[0]),Jt-Zt>1&&(e[0][Zt]<de.min&&Zt++,e[0][Jt]>de.max&&Jt--),P.min=kn[Zt],P.max=kn[Jt]}else P.show&&P.auto&&Dt(de,se,P,e[k],P.sorted);P.idxs[0]=Zt,P.idxs[1]=Jt}else if(k>0&&P.show&&P.auto){let[$,se]=P.facets,de=$.scale,xe=se.scale,[Te,Re]=e[k],De=_[de],Qe=_[xe];De!=null&&Dt(De,V[de],$,Te,$.sorted),Qe!=null&&Dt(Qe,V[xe],se,Re,se.sorted),P.min=se.min,P.max=se.max}});for(let P in _){let k=_[P],$=V[P];if(k.from==null&&($==null||$.min==null)){let se=k.range(n,k.min==It?null:k.min,k.max==-It?null:k.max,P);k.min=se[0],k.max=se[1]}}}for(let P in _){let k=_[P];if(k.from!=null){let $=_[k.from];if($.min==null)k.min=k.max=null;else{let se=k.range(n,$.min,$.max,P);k.min=se[0],k.max=se[1]}}}let b={},C=!1;for(let P in _){let k=_[P],$=w[P];if($.min!=k.min||$.max!=k.max){$.min=k.min,$.max=k.max;let se=$.distr;$._min=se==3?ss($.min):se==4?Ou($.min,$.asinh):se==100?$.fwd($.min):$.min,$._max=se==3?ss($.max):se==4?Ou($.max,$.asinh):se==100?$.fwd($.max):$.max,b[P]=C=!0}}if(C){y.forEach((P,k)=>{s==2?k>0&&b.y&&(P._paths=null):b[P.scale]&&(P._paths=null)});for(let P in b)Je=!0,hn("setScale",P);it&&ue.left>=0&&(B=fe=!0)}for(let P in V)V[P]=null}function ze(_){let b=Xu(Zt-1,0,tn-1),C=Xu(Jt+1,0,tn-1);for(;_[b]==null&&b>0;)b--;for(;_[C]==null&&C<tn-1;)C++;return[b,C]}function An(){if(tn>0){let _=y.some(b=>b._focus)&&Ee!=Bn.alpha;_&&(f.globalAlpha=Ee=Bn.alpha),y.forEach((b,C)=>{if(C>0&&b.show&&(lt(C,!1),lt(C,!0),b._paths==null)){let P=Ee;Ee!=b.alpha&&(f.globalAlpha=Ee=b.alpha);let k=s==2?[0,e[C][0].length-1]:ze(e[C]);b._paths=b.paths(n,C,k[0],k[1]),Ee!=P&&(f.globalAlpha=Ee=P)}}),y.forEach((b,C)=>{if(C>0&&b.show){let P=Ee;Ee!=b.alpha&&(f.globalAlpha=Ee=b.alpha),b._paths!=null&&Nn(C,!1);{let k=b._paths!=null?b._paths.gaps:null,$=b.points.show(n,C,Zt,Jt,k),se=b.points.filter(n,C,$,k);($||se)&&(b.points._paths=b.points.paths(n,C,Zt,Jt,se),Nn(C,!0))}Ee!=P&&(f.globalAlpha=Ee=P),hn("drawSeries",C)}}),_&&(f.globalAlpha=Ee=1)}}function lt(_,b){let C=b?y[_].points:y[_];C._stroke=C.stroke(n,_),C._fill=C.fill(n,_)}function Nn(_,b){let C=b?y[_].points:y[_],{stroke:P,fill:k,clip:$,flags:se,_stroke:de=C._stroke,_fill:xe=C._fill,_width:Te=C.width}=C._paths;Te=Pt(Te*bt,3);let Re=null,De=Te%2/2;b&&xe==null&&(xe=Te>0?"#fff":de);let Qe=C.pxAlign==1&&De>0;if(Qe&&f.translate(De,De),!b){let yt=Be-Te/2,mt=ae-Te/2,ot=he+Te,We=we+Te;Re=new Path2D,Re.rect(yt,mt,ot,We)}b?Ai(de,Te,C.dash,C.cap,xe,P,k,se,$):ei(_,de,Te,C.dash,C.cap,xe,P,k,se,Re,$),Qe&&f.translate(-De,-De)}function ei(_,b,C,P,k,$,se,de,xe,Te,Re){let De=!1;xe!=0&&D.forEach((Qe,yt)=>{if(Qe.series[0]==_){let mt=y[Qe.series[1]],ot=e[Qe.series[1]],We=(mt._paths||ma).band;Ns(We)&&(We=Qe.dir==1?We[0]:We[1]);let Ve,Ut=null;mt.show&&We&&xb(ot,Zt,Jt)?(Ut=Qe.fill(n,yt)||$,Ve=mt._paths.clip):We=null,Ai(b,C,P,k,Ut,se,de,xe,Te,Re,Ve,We),De=!0}}),De||Ai(b,C,P,k,$,se,de,xe,Te,Re)}let wi=ho|$u;function Ai(_,b,C,P,k,$,se,de,xe,Te,Re,De){xt(_,b,C,P,k),(xe||Te||De)&&(f.save(),xe&&f.clip(xe),Te&&f.clip(Te)),De?(de&wi)==wi?(f.clip(De),Re&&f.clip(Re),Gt(k,se),pt(_,$,b)):de&$u?(Gt(k,se),f.clip(De),pt(_,$,b)):de&ho&&(f.save(),f.clip(De),Re&&f.clip(Re),Gt(k,se),f.restore(),pt(_,$,b)):(Gt(k,se),pt(_,$,b)),(xe||Te||De)&&f.restore()}function pt(_,b,C){C>0&&(b instanceof Map?b.forEach((P,k)=>{f.strokeStyle=J=k,f.stroke(P)}):b!=null&&_&&f.stroke(b))}function Gt(_,b){b instanceof Map?b.forEach((C,P)=>{f.fillStyle=Y=P,f.fill(C)}):b!=null&&_&&f.fill(b)}function Ti(_,b,C,P){let k=A[_],$;if(P<=0)$=[0,0];else{let se=k._space=k.space(n,_,b,C,P),de=k._incrs=k.incrs(n,_,b,C,P,se);$=kS(b,C,de,P,se)}return k._found=$}function Ht(_,b,C,P,k,$,se,de,xe,Te){let Re=se%2/2;M==1&&f.translate(Re,Re),xt(de,se,xe,Te,de),f.beginPath();let De,Qe,yt,mt,ot=k+(P==0||P==3?-$:$);C==0?(Qe=k,mt=ot):(De=k,yt=ot);for(let We=0;We<_.length;We++)b[We]!=null&&(C==0?De=yt=_[We]:Qe=mt=_[We],f.moveTo(De,Qe),f.lineTo(yt,mt));f.stroke(),M==1&&f.translate(-Re,-Re)}function Ei(_){let b=!0;return A.forEach((C,P)=>{if(!C.show)return;let k=w[C.scale];if(k.min==null){C._show&&(b=!1,C._show=!1,gr(!1));return}else C._show||(b=!1,C._show=!0,gr(!1));let $=C.side,se=$%2,{min:de,max:xe}=k,[Te,Re]=Ti(P,de,xe,se==0?x:L);if(Re==0)return;let De=k.distr==2,Qe=C._splits=C.splits(n,P,de,xe,Te,Re,De),yt=k.distr==2?Qe.map(Ve=>kn[Ve]):Qe,mt=k.distr==2?kn[Qe[1]]-kn[Qe[0]]:Te,ot=C._values=C.values(n,C.filter(n,yt,P,Re,mt),P,Re,mt);C._rotate=$==2?C.rotate(n,ot,P,Re):0;let We=C._size;C._size=li(C.size(n,ot,P,_)),We!=null&&C._size!=We&&(b=!1)}),b}function ls(_){let b=!0;return go.forEach((C,P)=>{let k=C(n,P,bi,_);k!=Si[P]&&(b=!1),Si[P]=k}),b}function ya(){for(let _=0;_<A.length;_++){let b=A[_];if(!b.show||!b._show)continue;let C=b.side,P=C%2,k,$,se=b.stroke(n,_),de=C==0||C==3?-1:1,[xe,Te]=b._found;if(b.label!=null){let En=b.labelGap*de,Gn=rn((b._lpos+En)*bt);kt(b.labelFont[0],se,"center",C==2?"top":Bp),f.save(),P==1?(k=$=0,f.translate(Gn,rn(ae+we/2)),f.rotate((C==3?-Uc:Uc)/2)):(k=rn(Be+he/2),$=Gn);let Bs=Em(b.label)?b.label(n,_,xe,Te):b.label;f.fillText(Bs,k,$),f.restore()}if(Te==0)continue;let Re=w[b.scale],De=P==0?he:we,Qe=P==0?Be:ae,yt=b._splits,mt=Re.distr==2?yt.map(En=>kn[En]):yt,ot=Re.distr==2?kn[yt[1]]-kn[yt[0]]:xe,We=b.ticks,Ve=b.border,Ut=We.show?We.size:0,Wt=rn(Ut*bt),un=rn((b.alignTo==2?b._size-Ut-b.gap:b.gap)*bt),Ct=b._rotate*-Uc/180,Xt=p(b._pos*bt),zn=(Wt+un)*de,Tn=Xt+zn;$=P==0?Tn:0,k=P==1?Tn:0;let ti=b.font[0],ci=b.align==1?so:b.align==2?Nu:Ct>0?so:Ct<0?Nu:P==0?"center":C==3?Nu:so,Ii=Ct||P==1?"middle":C==2?"top":Bp;kt(ti,se,ci,Ii);let Vn=b.font[1]*b.lineGap,ni=yt.map(En=>p(a(En,Re,De,Qe))),hi=b._values;for(let En=0;En<hi.length;En++){let Gn=hi[En];if(Gn!=null){P==0?k=ni[En]:$=ni[En],Gn=""+Gn;let Bs=Gn.indexOf(`
`)==-1?[Gn]:Gn.split(/\n/gm);for(let Cn=0;Cn<Bs.length;Cn++){let Ff=Bs[Cn];Ct?(f.save(),f.translate(k,$+Cn*Vn),f.rotate(Ct),f.fillText(Ff,0,0),f.restore()):f.fillText(Ff,k,$+Cn*Vn)}}}We.show&&Ht(ni,We.filter(n,mt,_,Te,ot),P,C,Xt,Wt,Pt(We.width*bt,3),We.stroke(n,_),We.dash,We.cap);let Pi=b.grid;Pi.show&&Ht(ni,Pi.filter(n,mt,_,Te,ot),P,P==0?2:1,P==0?ae:Be,P==0?we:he,Pt(Pi.width*bt,3),Pi.stroke(n,_),Pi.dash,Pi.cap),Ve.show&&Ht([Xt],[1],P==0?1:0,P==0?1:2,P==1?ae:Be,P==1?we:he,Pt(Ve.width*bt,3),Ve.stroke(n,_),Ve.dash,Ve.cap)}hn("drawAxes")}function gr(_){y.forEach((b,C)=>{C>0&&(b._paths=null,_&&(s==1?(b.min=null,b.max=null):b.facets.forEach(P=>{P.min=null,P.max=null})))})}let Ma=!1,Qc=!1,_o=[];function Vg(){Qc=!1;for(let _=0;_<_o.length;_++)hn(..._o[_]);_o.length=0}function _r(){Ma||(Lb(_f),Ma=!0)}function Gg(_,b=!1){Ma=!0,Qc=b,_(n),_f(),b&&_o.length>0&&queueMicrotask(Vg)}n.batch=Gg;function _f(){if(Ne&&(an(),Ne=!1),Je&&(Ue(),Je=!1),Ae){if(Bt(d,so,K),Bt(d,"top",ne),Bt(d,ua,x),Bt(d,fa,L),Bt(g,so,K),Bt(g,"top",ne),Bt(g,ua,x),Bt(g,fa,L),Bt(u,ua,Ie),Bt(u,fa,I),h.width=rn(Ie*bt),h.height=rn(I*bt),A.forEach(({_el:_,_show:b,_size:C,_pos:P,side:k})=>{if(_!=null)if(b){let $=k===3||k===0?C:0,se=k%2==1;Bt(_,se?"left":"top",P-$),Bt(_,se?"width":"height",C),Bt(_,se?"top":"left",se?ne:K),Bt(_,se?"height":"width",se?L:x),Hu(_,or)}else Kn(_,or)}),J=Y=ye=Me=Fe=ke=je=tt=Ce=null,Ee=1,yo(!0),K!=ee||ne!=Pe||x!=ge||L!=Oe){gr(!1);let _=x/ge,b=L/Oe;if(it&&!B&&ue.left>=0){ue.left*=_,ue.top*=b,xr&&Hi(xr,rn(ue.left),0,x,L),vr&&Hi(vr,0,rn(ue.top),x,L);for(let C=0;C<wn.length;C++){let P=wn[C];P!=null&&(Wi[C]*=_,Dn[C]*=b,Hi(P,li(Wi[C]),li(Dn[C]),x,L))}}if(Ft.show&&!ve&&Ft.left>=0&&Ft.width>0){Ft.left*=_,Ft.width*=_,Ft.top*=b,Ft.height*=b;for(let C in rh)Bt(br,C,Ft[C])}ee=K,Pe=ne,ge=x,Oe=L}hn("setSize"),Ae=!1}Ie>0&&I>0&&(f.clearRect(0,0,h.width,h.height),hn("drawClear"),v.forEach(_=>_()),hn("draw")),Ft.show&&ve&&(ba(Ft),ve=!1),it&&B&&(Os(null,!0,!1),B=!1),oe.show&&oe.live&&fe&&(ih(),fe=!1),l||(l=!0,n.status=1,hn("ready")),S=!1,Ma=!1}n.redraw=(_,b)=>{Je=b||!1,_!==!1?hs(R,E.min,E.max):_r()};function eh(_,b){let C=w[_];if(C.from==null){if(tn==0){let P=C.range(n,b.min,b.max,_);b.min=P[0],b.max=P[1]}if(b.min>b.max){let P=b.min;b.min=b.max,b.max=P}if(tn>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;_==R&&C.distr==2&&tn>0&&(b.min=xi(b.min,e[0]),b.max=xi(b.max,e[0]),b.min==b.max&&b.max++),V[_]=b,Ne=!0,_r()}}n.setScale=eh;let th,nh,xr,vr,xf,vf,yr,Mr,yf,Mf,Nt,zt,cs=!1,pn=ue.drag,ln=pn.x,cn=pn.y;it&&(ue.x&&(th=ai(nb,g)),ue.y&&(nh=ai(ib,g)),E.ori==0?(xr=th,vr=nh):(xr=nh,vr=th),Nt=ue.left,zt=ue.top);let Ft=n.select=en({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),br=Ft.show?ai(tb,Ft.over?g:d):null;function ba(_,b){if(Ft.show){for(let C in _)Ft[C]=_[C],C in rh&&Bt(br,C,_[C]);b!==!1&&hn("setSelect")}}n.setSelect=ba;function Hg(_){if(y[_].show)et&&Hu(Se[_],or);else if(et&&Kn(Se[_],or),it){let C=os?wn[0]:wn[_];C!=null&&Hi(C,-10,-10,x,L)}}function hs(_,b,C){eh(_,{min:b,max:C})}function Ci(_,b,C,P){b.focus!=null&&$g(_),b.show!=null&&y.forEach((k,$)=>{$>0&&(_==$||_==null)&&(k.show=b.show,Hg($),s==2?(hs(k.facets[0].scale,null,null),hs(k.facets[1].scale,null,null)):hs(k.scale,null,null),_r())}),C!==!1&&hn("setSeries",_,b),P&&Mo("setSeries",n,_,b)}n.setSeries=Ci;function Wg(_,b){en(D[_],b)}function Xg(_,b){_.fill=at(_.fill||null),_.dir=gt(_.dir,-1),b=b??D.length,D.splice(b,0,_)}function qg(_){_==null?D.length=0:D.splice(_,1)}n.addBand=Xg,n.setBand=Wg,n.delBand=qg;function Yg(_,b){y[_].alpha=b,it&&wn[_]!=null&&(wn[_].style.opacity=b),et&&Se[_]&&(Se[_].style.opacity=b)}let Xi,us,Us,Sr={focus:!0};function $g(_){if(_!=Us){let b=_==null,C=Bn.alpha!=1;y.forEach((P,k)=>{if(s==1||k>0){let $=b||k==0||k==_;P._focus=b?null:$,C&&Yg(k,$?1:Bn.alpha)}}),Us=_,C&&_r()}}et&&Mi&&Ze(Gp,re,_=>{ue._lock||(dn(_),Us!=null&&Ci(null,Sr,!0,Kt.setSeries))});function Ri(_,b,C){let P=w[b];C&&(_=_/bt-(P.ori==1?ne:K));let k=x;P.ori==1&&(k=L,_=k-_),P.dir==-1&&(_=k-_);let $=P._min,se=P._max,de=_/k,xe=$+(se-$)*de,Te=P.distr;return Te==3?ao(10,xe):Te==4?yb(xe,P.asinh):Te==100?P.bwd(xe):xe}function Zg(_,b){let C=Ri(_,R,b);return xi(C,e[0],Zt,Jt)}n.valToIdx=_=>xi(_,e[0]),n.posToIdx=Zg,n.posToVal=Ri,n.valToPos=(_,b,C)=>w[b].ori==0?r(_,w[b],C?he:x,C?Be:0):o(_,w[b],C?we:L,C?ae:0),n.setCursor=(_,b,C)=>{Nt=_.left,zt=_.top,Os(null,b,C)};function bf(_,b){Bt(br,so,Ft.left=_),Bt(br,ua,Ft.width=b)}function Sf(_,b){Bt(br,"top",Ft.top=_),Bt(br,fa,Ft.height=b)}let xo=E.ori==0?bf:Sf,vo=E.ori==1?bf:Sf;function Jg(){if(et&&oe.live)for(let _=s==2?1:0;_<y.length;_++){if(_==0&&Ye)continue;let b=oe.values[_],C=0;for(let P in b)Ge[_][C++].firstChild.nodeValue=b[P]}}function ih(_,b){if(_!=null&&(_.idxs?_.idxs.forEach((C,P)=>{_e[P]=C}):wb(_.idx)||_e.fill(_.idx),oe.idx=_e[0]),et&&oe.live){for(let C=0;C<y.length;C++)(C>0||s==1&&!Ye)&&Kg(C,_e[C]);Jg()}fe=!1,b!==!1&&hn("setLegend")}n.setLegend=ih;function Kg(_,b){let C=y[_],P=_==0&&G==2?kn:e[_],k;Ye?k=C.values(n,_,b)??rt:(k=C.value(n,b==null?null:P[b],_,b),k=k==null?rt:{_:k}),oe.values[_]=k}function Os(_,b,C){yf=Nt,Mf=zt,[Nt,zt]=ue.move(n,Nt,zt),ue.left=Nt,ue.top=zt,it&&(xr&&Hi(xr,rn(Nt),0,x,L),vr&&Hi(vr,0,rn(zt),x,L));let P,k=Zt>Jt;Xi=It,us=null;let $=E.ori==0?x:L,se=E.ori==1?x:L;if(Nt<0||tn==0||k){P=ue.idx=null;for(let de=0;de<y.length;de++){let xe=wn[de];xe!=null&&Hi(xe,-10,-10,x,L)}Mi&&Ci(null,Sr,!0,_==null&&Kt.setSeries),oe.live&&(_e.fill(P),fe=!0)}else{let de,xe,Te;s==1&&(de=E.ori==0?Nt:zt,xe=Ri(de,R),P=ue.idx=xi(xe,e[0],Zt,Jt),Te=O(e[0][P],E,$,0));let Re=-10,De=-10,Qe=0,yt=0,mt=!0,ot="",We="";for(let Ve=s==2?1:0;Ve<y.length;Ve++){let Ut=y[Ve],Wt=_e[Ve],un=Wt==null?null:s==1?e[Ve][Wt]:e[Ve][1][Wt],Ct=ue.dataIdx(n,Ve,P,xe),Xt=Ct==null?null:s==1?e[Ve][Ct]:e[Ve][1][Ct];if(fe=fe||Xt!=un||Ct!=Wt,_e[Ve]=Ct,Ve>0&&Ut.show){let zn=Ct==null?-10:Ct==P?Te:O(s==1?e[0][Ct]:e[Ve][0][Ct],E,$,0),Tn=Xt==null?-10:W(Xt,s==1?w[Ut.scale]:w[Ut.facets[1].scale],se,0);if(Mi&&Xt!=null){let ti=E.ori==1?Nt:zt,ci=on(Bn.dist(n,Ve,Ct,Tn,ti));if(ci<Xi){let Ii=Bn.bias;if(Ii!=0){let Vn=Ri(ti,Ut.scale),ni=Xt>=0?1:-1,hi=Vn>=0?1:-1;hi==ni&&(hi==1?Ii==1?Xt>=Vn:Xt<=Vn:Ii==1?Xt<=Vn:Xt>=Vn)&&(Xi=ci,us=Ve)}else Xi=ci,us=Ve}}if(fe||os){let ti,ci;E.ori==0?(ti=zn,ci=Tn):(ti=Tn,ci=zn);let Ii,Vn,ni,hi,Pi,En,Gn=!0,Bs=Lt.bbox;if(Bs!=null){Gn=!1;let Cn=Bs(n,Ve);ni=Cn.left,hi=Cn.top,Ii=Cn.width,Vn=Cn.height}else ni=ti,hi=ci,Ii=Vn=Lt.size(n,Ve);if(En=Lt.fill(n,Ve),Pi=Lt.stroke(n,Ve),os)Ve==us&&Xi<=Bn.prox&&(Re=ni,De=hi,Qe=Ii,yt=Vn,mt=Gn,ot=En,We=Pi);else{let Cn=wn[Ve];Cn!=null&&(Wi[Ve]=ni,Dn[Ve]=hi,Zp(Cn,Ii,Vn,Gn),Yp(Cn,En,Pi),Hi(Cn,li(ni),li(hi),x,L))}}}}if(os){let Ve=Bn.prox,Ut=Us==null?Xi<=Ve:Xi>Ve||us!=Us;if(fe||Ut){let Wt=wn[0];Wt!=null&&(Wi[0]=Re,Dn[0]=De,Zp(Wt,Qe,yt,mt),Yp(Wt,ot,We),Hi(Wt,li(Re),li(De),x,L))}}}if(Ft.show&&cs)if(_!=null){let[de,xe]=Kt.scales,[Te,Re]=Kt.match,[De,Qe]=_.cursor.sync.scales,yt=_.cursor.drag;if(ln=yt._x,cn=yt._y,ln||cn){let{left:mt,top:ot,width:We,height:Ve}=_.select,Ut=_.scales[De].ori,Wt=_.posToVal,un,Ct,Xt,zn,Tn,ti=de!=null&&Te(de,De),ci=xe!=null&&Re(xe,Qe);ti&&ln?(Ut==0?(un=mt,Ct=We):(un=ot,Ct=Ve),Xt=w[de],zn=O(Wt(un,De),Xt,$,0),Tn=O(Wt(un+Ct,De),Xt,$,0),xo(vi(zn,Tn),on(Tn-zn))):xo(0,$),ci&&cn?(Ut==1?(un=mt,Ct=We):(un=ot,Ct=Ve),Xt=w[xe],zn=W(Wt(un,Qe),Xt,se,0),Tn=W(Wt(un+Ct,Qe),Xt,se,0),vo(vi(zn,Tn),on(Tn-zn))):vo(0,se)}else oh()}else{let de=on(yf-xf),xe=on(Mf-vf);if(E.ori==1){let Qe=de;de=xe,xe=Qe}ln=pn.x&&de>=pn.dist,cn=pn.y&&xe>=pn.dist;let Te=pn.uni;Te!=null?ln&&cn&&(ln=de>=Te,cn=xe>=Te,!ln&&!cn&&(xe>de?cn=!0:ln=!0)):pn.x&&pn.y&&(ln||cn)&&(ln=cn=!0);let Re,De;ln&&(E.ori==0?(Re=yr,De=Nt):(Re=Mr,De=zt),xo(vi(Re,De),on(De-Re)),cn||vo(0,se)),cn&&(E.ori==1?(Re=yr,De=Nt):(Re=Mr,De=zt),vo(vi(Re,De),on(De-Re)),ln||xo(0,$)),!ln&&!cn&&(xo(0,0),vo(0,0))}if(pn._x=ln,pn._y=cn,_==null){if(C){if(Nf!=null){let[de,xe]=Kt.scales;Kt.values[0]=de!=null?Ri(E.ori==0?Nt:zt,de):null,Kt.values[1]=xe!=null?Ri(E.ori==1?Nt:zt,xe):null}Mo(Fu,n,Nt,zt,x,L,P)}if(Mi){let de=C&&Kt.setSeries,xe=Bn.prox;Us==null?Xi<=xe&&Ci(us,Sr,!0,de):Xi>xe?Ci(null,Sr,!0,de):us!=Us&&Ci(us,Sr,!0,de)}}fe&&(oe.idx=P,ih()),b!==!1&&hn("setCursor")}let fs=null;Object.defineProperty(n,"rect",{get(){return fs==null&&yo(!1),fs}});function yo(_=!1){_?fs=null:(fs=g.getBoundingClientRect(),hn("syncRect",fs))}function wf(_,b,C,P,k,$,se){ue._lock||cs&&_!=null&&_.movementX==0&&_.movementY==0||(sh(_,b,C,P,k,$,se,!1,_!=null),_!=null?Os(null,!0,!0):Os(b,!0,!1))}function sh(_,b,C,P,k,$,se,de,xe){if(fs==null&&yo(!1),dn(_),_!=null)C=_.clientX-fs.left,P=_.clientY-fs.top;else{if(C<0||P<0){Nt=-10,zt=-10;return}let[Te,Re]=Kt.scales,De=b.cursor.sync,[Qe,yt]=De.values,[mt,ot]=De.scales,[We,Ve]=Kt.match,Ut=b.axes[0].side%2==1,Wt=E.ori==0?x:L,un=E.ori==1?x:L,Ct=Ut?$:k,Xt=Ut?k:$,zn=Ut?P:C,Tn=Ut?C:P;if(mt!=null?C=We(Te,mt)?a(Qe,w[Te],Wt,0):-10:C=Wt*(zn/Ct),ot!=null?P=Ve(Re,ot)?a(yt,w[Re],un,0):-10:P=un*(Tn/Xt),E.ori==1){let ti=C;C=P,P=ti}}xe&&(b==null||b.cursor.event.type==Fu)&&((C<=1||C>=x-1)&&(C=sr(C,x)),(P<=1||P>=L-1)&&(P=sr(P,L))),de?(xf=C,vf=P,[yr,Mr]=ue.move(n,C,P)):(Nt=C,zt=P)}let rh={width:0,height:0,left:0,top:0};function oh(){ba(rh,!1)}let Af,Tf,Ef,Cf;function Rf(_,b,C,P,k,$,se){cs=!0,ln=cn=pn._x=pn._y=!1,sh(_,b,C,P,k,$,se,!0,!1),_!=null&&(Ze(Uu,Vu,If,!1),Mo(zp,n,yr,Mr,x,L,null));let{left:de,top:xe,width:Te,height:Re}=Ft;Af=de,Tf=xe,Ef=Te,Cf=Re}function If(_,b,C,P,k,$,se){cs=pn._x=pn._y=!1,sh(_,b,C,P,k,$,se,!1,!0);let{left:de,top:xe,width:Te,height:Re}=Ft,De=Te>0||Re>0,Qe=Af!=de||Tf!=xe||Ef!=Te||Cf!=Re;if(De&&Qe&&ba(Ft),pn.setScale&&De&&Qe){let yt=de,mt=Te,ot=xe,We=Re;if(E.ori==1&&(yt=xe,mt=Re,ot=de,We=Te),ln&&hs(R,Ri(yt,R),Ri(yt+mt,R)),cn)for(let Ve in w){let Ut=w[Ve];Ve!=R&&Ut.from==null&&Ut.min!=It&&hs(Ve,Ri(ot+We,Ve),Ri(ot,Ve))}oh()}else ue.lock&&(ue._lock=!ue._lock,Os(b,!0,_!=null));_!=null&&(dt(Uu,Vu),Mo(Uu,n,Nt,zt,x,L,null))}function jg(_,b,C,P,k,$,se){if(ue._lock)return;dn(_);let de=cs;if(cs){let xe=!0,Te=!0,Re=10,De,Qe;E.ori==0?(De=ln,Qe=cn):(De=cn,Qe=ln),De&&Qe&&(xe=Nt<=Re||Nt>=x-Re,Te=zt<=Re||zt>=L-Re),De&&xe&&(Nt=Nt<yr?0:x),Qe&&Te&&(zt=zt<Mr?0:L),Os(null,!0,!0),cs=!1}Nt=-10,zt=-10,_e.fill(null),Os(null,!0,!0),de&&(cs=de)}function Pf(_,b,C,P,k,$,se){ue._lock||(dn(_),j(),oh(),_!=null&&Mo(Hp,n,Nt,zt,x,L,null))}function Lf(){A.forEach(zS),Le(n.width,n.height,!0)}ar(Oc,oo,Lf);let wr={};wr.mousedown=Rf,wr.mousemove=wf,wr.mouseup=If,wr.dblclick=Pf,wr.setSeries=(_,b,C,P)=>{let k=Kt.match[2];C=k(n,b,C),C!=-1&&Ci(C,P,!0,!1)},it&&(Ze(zp,g,Rf),Ze(Fu,g,wf),Ze(Vp,g,_=>{dn(_),yo(!1)}),Ze(Gp,g,jg),Ze(Hp,g,Pf),Zu.add(n),n.syncRect=yo);let Sa=n.hooks=i.hooks||{};function hn(_,b,C){Qc?_o.push([_,b,C]):_ in Sa&&Sa[_].forEach(P=>{P.call(null,n,b,C)})}(i.plugins||[]).forEach(_=>{for(let b in _.hooks)Sa[b]=(Sa[b]||[]).concat(_.hooks[b])});let Df=(_,b,C)=>C,Kt=en({key:null,setSeries:!1,filters:{pub:em,sub:em},scales:[R,y[1]?y[1].scale:null],match:[tm,tm,Df],values:[null,null]},ue.sync);Kt.match.length==2&&Kt.match.push(Df),ue.sync=Kt;let Nf=Kt.key,ah=Km(Nf);function Mo(_,b,C,P,k,$,se){Kt.filters.pub(_,b,C,P,k,$,se)&&ah.pub(_,b,C,P,k,$,se)}ah.sub(n);function Qg(_,b,C,P,k,$,se){Kt.filters.sub(_,b,C,P,k,$,se)&&wr[_](null,b,C,P,k,$,se)}n.pub=Qg;function e0(){ah.unsub(n),Zu.delete(n),Tt.clear(),Wu(Oc,oo,Lf),c.remove(),re?.remove(),hn("destroy")}n.destroy=e0;function lh(){hn("init",i,e),X(e||i.data,!1),V[R]?eh(R,V[R]):j(),ve=Ft.show&&(Ft.width>0||Ft.height>0),B=fe=!0,Le(i.width,i.height)}return y.forEach(mo),A.forEach(pr),t?t instanceof HTMLElement?(t.appendChild(c),lh()):t(n,lh):lh(),n}xn.assign=en;xn.fmtNum=nf;xn.rangeNum=Bc;xn.rangeLog=Vc;xn.rangeAsinh=ef;xn.orient=cr;xn.pxRatio=bt;xn.join=Pb;xn.fmtDate=rf,xn.tzDate=Gb;xn.sync=Km;{xn.addGap=wS,xn.clipGaps=Wc;let i=xn.paths={points:ig};i.linear=rg,i.stepped=ES,i.bars=CS,i.spline=IS}var VS=[{key:"cost",title:"Cost",log:!0},{key:"max_move",title:"Largest move",log:!0},{key:"gradient",title:"Gradient",log:!0},{key:"worst",title:"Worst quality",log:!1},{key:"inverted",title:"Inverted cells",log:!1}];function hg(i,e){if(!(i?.length>1))return null;let t=i.map(({iteration:o},a)=>o??a),n=VS.map(o=>GS(o,t,i,e)).filter(Boolean);if(n.length===0)return null;let s=z("section",{class:"em-card em-wide"},z("h2",null,"Convergence"),ug(i).length>0&&z("p",{class:"em-hint"},"Dashed: the cost itself changed there (penalties or multipliers); compare it only between two such lines."),z("div",{class:"em-charts"},...n.map(({element:o})=>o))),r=new ResizeObserver(()=>{for(let{resize:o}of n)o()});for(let{element:o}of n)r.observe(o);return{element:s,redraw:()=>n.forEach(({redraw:o})=>o()),dispose:()=>r.disconnect()}}function ug(i){return i.filter((e,t)=>t>0&&e.function!==i[t-1].function).map(({iteration:e})=>e)}function GS({key:i,title:e,log:t},n,s,r){let o=s.map(p=>p[i]);if(!o.some(p=>Number.isFinite(p))||i==="inverted"&&o.every(p=>!p))return null;let a=t&&o.some(p=>p>0),l=o.map(p=>Number.isFinite(p)&&(!a||p>0)?p:null),c=z("output",{class:"em-reading"}),h=p=>{c.textContent=p==null?"":`${Vt(o[p])} at ${n[p]}`},f=z("div",{class:"em-chart",role:"img","aria-label":`${e} over ${s.length-1} iterations: from ${Vt(o[0])} to ${Vt(o.at(-1))}`}),u=z("figure",null,z("figcaption",null,e,z("small",null,a?" (log)":""),c),f),d={stroke:()=>r().muted,grid:{stroke:()=>r().grid,width:1},ticks:{stroke:()=>r().grid,width:1},font:"12px system-ui, sans-serif"},g,M=()=>{g=new xn({width:f.clientWidth||320,height:170,legend:{show:!1},cursor:{sync:{key:"evenmesh"},drag:{x:!1,y:!1},points:{size:7}},scales:{x:{time:!1},y:a?{distr:3,log:10,range:HS}:{range:{min:{pad:.1,soft:0,mode:1},max:{pad:.1}}}},axes:[{...d,incrs:[1,2,5,10,20,50,100,200,500,1e3,2e3,5e3,1e4],size:34},{...d,size:62,values:(p,m)=>m.map(y=>y===null?"":Vt(y,3))}],series:[{},{stroke:()=>r().accent,width:2,spanGaps:!0,points:{show:s.length<=40,size:5,fill:()=>r().accent,stroke:()=>r().accent}}],hooks:{setCursor:[p=>h(p.cursor.idx)],draw:[p=>WS(p,ug(s),r)]}},[n,l],f)};return{element:u,resize(){g?f.clientWidth>0&&g.setSize({width:f.clientWidth,height:170}):M()},redraw:()=>g?.redraw(!1,!0)}}function HS(i,e,t){return e>0?t/e>100?[10**Math.floor(Math.log10(e)),10**Math.ceil(Math.log10(t))]:[cg(e,[5,2,1],(n,s)=>n<=s),cg(t,[1,2,5,10],(n,s)=>n>=s)]:[.1,1]}function cg(i,e,t){let n=10**Math.floor(Math.log10(i));return n*e.find(s=>t(s,i/n*(e[0]===5?1.001:.999)))}function WS(i,e,t){let{ctx:n,bbox:s}=i;n.save(),n.strokeStyle=t().muted,n.setLineDash([4,4]);for(let r of e){let o=Math.round(i.valToPos(r,"x",!0))+.5;n.beginPath(),n.moveTo(o,s.top),n.lineTo(o,s.top+s.height),n.stroke()}n.restore()}function fg({mesh:i,store:e,stage:t,actions:n}){let s=h=>()=>e.set({[h]:!e.get()[h]}),{view:r}=t,o=(h,f)=>u=>{i.dimension===2||u.shiftKey?r.pan(-h*40,-f*40,t.size.height):r.turn(-h*16,-f*16)},a=h=>()=>n.lookAlong(h),l=!!i.after,c=i.dimension===3;return[l&&{keys:["b"],shown:"B",what:"blink: change between before and after",run:n.blink},l&&{keys:["1"],shown:"1",what:"side by side",run:()=>e.set({mode:"side"})},l&&{keys:["2"],shown:"2",what:"wipe",run:()=>e.set({mode:"wipe"})},l&&{keys:["3"],shown:"3",what:"single",run:()=>e.set({mode:"single"})},l&&{keys:["["],shown:"[ ]",what:"scrub back, forward",run:()=>n.scrubBy(-.1)},l&&{keys:["]"],run:()=>n.scrubBy(.1)},{keys:["e"],shown:"E",what:"cell edges",run:s("edges")},c&&{keys:["o"],shown:"O",what:"shape edges",run:s("features")},{keys:["m"],shown:"M",what:"held vertices",run:s("marks")},l&&{keys:["v"],shown:"V",what:"moves",run:s("vectors")},{keys:["n"],shown:"N P",what:"next, previous of the worst cells",run:()=>n.nextWorst(1)},{keys:["p"],run:()=>n.nextWorst(-1)},{keys:["g"],shown:"G",what:"go to the chosen cell",run:n.goToSelected},{keys:["Escape"],shown:"Esc",what:"choose no cell",run:()=>e.set({selected:-1})},{keys:["f"],shown:"F",what:"fit the whole mesh",run:n.fit},c&&{keys:["x"],shown:"X Y Z",what:"look along an axis",run:a([1,0,0])},c&&{keys:["y"],run:a([0,-1,0])},c&&{keys:["z"],run:a([0,0,1])},{keys:["ArrowLeft"],shown:"arrows",what:c?"turn; with Shift: move":"move",canvas:!0,run:o(-1,0)},{keys:["ArrowRight"],canvas:!0,run:o(1,0)},{keys:["ArrowUp"],canvas:!0,run:o(0,-1)},{keys:["ArrowDown"],canvas:!0,run:o(0,1)},{keys:["+","="],shown:"+ \u2212",what:"zoom",run:()=>r.zoom(1/1.25)},{keys:["-"],run:()=>r.zoom(1.25)},{keys:["t"],shown:"T",what:"light or dark",run:n.theme},{keys:["?"],shown:"?",what:"these keys",run:n.keys}].filter(Boolean)}function dg(i,e,t){let n=s=>{if(s.ctrlKey||s.metaKey||s.altKey||s.defaultPrevented||s.target.closest?.("input:not([type=range]), select, textarea, dialog[open]"))return;let r=s.key.length===1?s.key.toLowerCase():s.key,o=e.find(a=>a.keys.includes(r));!o||o.canvas&&s.target!==t||(s.preventDefault(),o.run(s))};return i.addEventListener("keydown",n),()=>i.removeEventListener("keydown",n)}function pg(i){return z("dialog",{class:"em-dialog","aria-label":"Keys"},z("h2",null,"Keys"),z("dl",null,...i.filter(({shown:t})=>t).flatMap(({shown:t,what:n})=>[z("dt",null,...t.split(" ").map(s=>z("kbd",null,s))),z("dd",null,n)])),z("p",{class:"em-hint"},"Mouse: drag to turn (with Shift or the right button: move), wheel to zoom, click to choose a cell, double click to go there."),z("form",{method:"dialog"},z("button",{class:"em-button"},"Close")))}var ff=64;function mg(i,e){let t=z("div",{class:"em-legend"}),n=({values:r,marks:o})=>{t.replaceChildren(...[r&&XS(r),o&&YS(e().holds)].filter(Boolean))},s=i.on(["values","marks"],n);return{element:t,redraw:()=>n(i.get()),dispose:s}}function XS(i){let e=qt("svg",{viewBox:`0 0 ${ff} 8`,preserveAspectRatio:"none",class:"em-colours","shape-rendering":"crispEdges","aria-hidden":"true"},...Array.from({length:ff},(r,o)=>qt("rect",{x:o,y:0,width:1,height:8,fill:ns(to(aa(i,254*(o+.5)/ff)))}))),t=qt("svg",{viewBox:"0 0 16 12",class:"em-swatch","aria-hidden":"true"},qt("rect",{width:16,height:12,fill:ns(no)}),...[0,8,16].map(r=>qt("path",{d:`M${r-4} 12l12 -12h-4l-12 12z`,fill:ns(Ic)}))),n=i.before.includes(255)||i.after.includes(255),s=r=>Ds(Vt(r,3),i.unit);return z("div",{class:"em-legend-row"},z("span",{class:"em-legend-title"},Jn(i.name),z("small",null,` ${i.better} is better`)),z("span",{class:"em-legend-item"},s(i.low),e,s(i.high)),n&&z("span",{class:"em-legend-item"},t,"inverted or without size"))}function gg(i,e,{y:t,width:n,height:s},r){i.fillStyle=r.backgroundColor,i.fillRect(0,t,n,s),i.font="13px system-ui, sans-serif",i.textBaseline="middle";let o=t+s/2,a=12,l=c=>{i.fillStyle=r.color,i.fillText(c,a,o),a+=i.measureText(c).width+8};l(`${Jn(e.name)}, ${e.better} is better:`),l(Ds(Vt(e.low,3),e.unit));for(let c=0;c<180;++c)i.fillStyle=ns(to(aa(e,254*c/179))),i.fillRect(a+c,o-6,1.5,12);a+=188,l(Ds(Vt(e.high,3),e.unit))}var qS=[null,"M2 2h8v8h-8z","M6 1.5a4.5 4.5 0 1 0 .01 0z","M6 1.5a4.5 4.5 0 1 0 .01 0zM6 4.2a1.8 1.8 0 1 1 -.01 0z","M6 1l5 5l-5 5l-5 -5z","M1.5 2.5h9l-4.5 8z"];function YS(i){return z("ul",{class:"em-legend-row"},...qS.map((e,t)=>e&&z("li",{class:"em-legend-item"},qt("svg",{viewBox:"0 0 12 12",class:"em-swatch","aria-hidden":"true"},qt("path",{d:e,fill:ns(i[t]),class:"em-mark-shape"})),Ta[t])).filter(Boolean))}var df=[["worst","worst"],["p1","1 %"],["p5","5 %"],["median","median"],["mean","mean"]];function _g(i){if(!i?.length)return null;let e=i.some(({after:n})=>n),t=i.map(n=>z("tr",null,z("th",{scope:"row"},Jn(n.metric),n.unit?` (${n.unit})`:"",z("small",null,`${n.better} is better`)),...df.flatMap(([s])=>$S(n,s,e))));return z("section",{class:"em-card em-wide"},z("h2",null,"Quality of all cells"),z("div",{class:"em-scroll",tabindex:"0",role:"region","aria-label":"Quality of all cells"},z("table",{class:"em-table em-numbers"},z("thead",null,z("tr",null,z("td"),...df.map(([,n])=>z("th",{scope:"colgroup",colspan:e?2:1},n))),e&&z("tr",{class:"em-subhead"},z("td"),...df.flatMap(()=>[z("th",{scope:"col"},"before"),z("th",{scope:"col"},"after")]))),z("tbody",null,...t))))}function $S(i,e,t){let n=i.before?.[e],s=z("td",{class:"em-before"},Vt(n));if(!t)return[s];let r=i.after?.[e];return[s,z("td",{class:`em-after ${ZS(i.better,n,r)}`},Vt(r))]}function ZS(i,e,t){let n=e??1/0,s=t??1/0;return n===s||t===void 0||Math.abs(n-s)<1e-12?"":i==="lower"==s<n?"em-better":"em-worse"}function xg(i,e,t){let n=new Map,s=0,r=l=>{let c=i.getBoundingClientRect();return[l.clientX-c.left,l.clientY-c.top]},o=(l,c,h)=>{let{viewport:f}=t.paneAt(c,h),u=f.height/2;e.zoom(l,(c-f.x-f.width/2)/u,-(h-f.y-f.height/2)/u)};i.addEventListener("pointerdown",l=>{i.setPointerCapture(l.pointerId),i.focus({preventScroll:!0}),n.size===0&&(s=0),n.set(l.pointerId,{at:r(l),button:l.button,shift:l.shiftKey}),e.stop()}),i.addEventListener("pointermove",l=>{let c=r(l),h=n.get(l.pointerId);if(!h)return t.hover(...c);let[f,u]=c.map((g,M)=>g-h.at[M]);if(s+=Math.abs(f)+Math.abs(u),s<4)return;t.leave();let{height:d}=t.paneAt(...c).viewport;if(n.size===2){let g=[...n.values()].find(p=>p!==h).at,M=([p,m])=>Math.hypot(p-g[0],m-g[1])||1;e.pan(f/2,u/2,d),o(M(h.at)/M(c),(c[0]+g[0])/2,(c[1]+g[1])/2)}else e.planar||h.button!==0||h.shift?e.pan(f,u,d):e.turn(f,u);h.at=c});let a=l=>{let c=n.get(l.pointerId);n.delete(l.pointerId),l.type==="pointerup"&&c?.button===0&&s<4&&t.click(...r(l))};i.addEventListener("pointerup",a),i.addEventListener("pointercancel",a),i.addEventListener("pointerleave",()=>t.leave()),i.addEventListener("contextmenu",l=>l.preventDefault()),i.addEventListener("wheel",l=>{l.preventDefault(),e.stop();let c=l.deltaMode===1?20:1;o(Math.exp(Math.max(-120,Math.min(120,l.deltaY*c))*.0022),...r(l))},{passive:!1})}var hr=(i,e,t,n)=>({x:i,y:e,width:t,height:n});function vg({mode:i,wipe:e},{width:t,height:n},s,r){let o=hr(0,0,t,n);if(i==="single")return[{...r,viewport:o,scissor:o}];if(i==="wipe"){let c=Math.round(e*t);return[{...s,viewport:o,scissor:hr(0,0,c,n)},{...r,viewport:o,scissor:hr(c,0,t-c,n)}]}let[a,l]=t>=n?[hr(0,0,Math.floor(t/2)-1,n),hr(Math.floor(t/2)+1,0,Math.ceil(t/2)-1,n)]:[hr(0,0,t,Math.floor(n/2)-1),hr(0,Math.floor(n/2)+1,t,Math.ceil(n/2)-1)];return[{...s,viewport:a,scissor:a},{...r,viewport:l,scissor:l}]}function yg({mode:i},{width:e,height:t}){return i!=="side"?e/t:e>=t?e/2/t:e/(t/2)}var JS=({x:i,y:e,width:t,height:n},s,r)=>s>=i&&s<i+t&&r>=e&&r<e+n,Mg=(i,e,t)=>i.find(({scissor:n})=>JS(n,e,t))??i.at(-1);function Sg(i){let e=KS(i),t={count:0,cell:new Int32Array(e),side:new Uint8Array(e),other:new Int32Array(e).fill(-1),otherSide:new Uint8Array(e)};if(i.type!=="volume"){for(let r=0;r<i.cellCount;++r)t.cell[t.count++]=r;return t}let n=jS(e),s=r=>{for(let o=0;o<i.cellCount;++o){if(ii[i.kind[o]].volume!==r)continue;let l=Ar(i,o);for(let c=0;c<l.length;++c){let h=n(i.vertices,i.first[o],l[c],t.count);h===t.count?(t.cell[h]=o,t.side[h]=c,++t.count):t.other[h]<0&&(t.other[h]=o,t.otherSide[h]=c)}}};return s(!0),s(!1),t}function KS(i){let e=0;for(let t=0;t<i.cellCount;++t)e+=Ar(i,t).length;return e}function jS(i){let e=16;for(;e<2*i;)e*=2;let t=new Int32Array(e).fill(-1),n=new Uint32Array(4*i);return(s,r,o,a)=>{let l=s[r+o[0]],c=s[r+o[1]],h=s[r+o[2]],f;if(l>c&&(f=l,l=c,c=f),c>h&&(f=c,c=h,h=f),l>c&&(f=l,l=c,c=f),o.length===4){let d=s[r+o[3]];d<l?(h=c,c=l,l=d):d<c?(h=c,c=d):d<h&&(h=d)}let u=(Math.imul(l,73856093)^Math.imul(c,19349663)^Math.imul(h,83492791))>>>0;for(u=(u^u>>>15)&e-1;;u=u+1&e-1){let d=t[u];if(d<0)break;let g=4*d;if(n[g]===l&&n[g+1]===c&&n[g+2]===h&&n[g+3]===o.length)return d}return t[u]=a,n[4*a]=l,n[4*a+1]=c,n[4*a+2]=h,n[4*a+3]=o.length,a}}function wg(i,e,t,n){let s=tw(i,e,t,n),r=0;for(let l=0;l<s.length;l+=2)r+=Ar(i,s[l])[s[l+1]].length-2;let o=new Uint32Array(6*r),a=0;for(let l=0;l<s.length;l+=2){let c=s[l],h=Ar(i,c)[s[l+1]],f=i.first[c];if(h.length>4){a=QS(o,a,i,h.map(p=>i.vertices[f+p]),c);continue}let u=i.vertices[f+h[0]],d=i.vertices[f+h[1]],g=i.vertices[f+h[2]];if(h.length===3){a=$c(o,a,u,d,g,8*c+7);continue}let M=i.vertices[f+h[3]];(bg(i.before,u,d,g,M)||i.after&&bg(i.after,u,d,g,M))&&([u,d,g,M]=[d,g,M,u]),a=$c(o,a,u,d,g,8*c+5),a=$c(o,a,u,g,M,8*c+3)}return o}function QS(i,e,t,n,s){let r=[t.before,t.after].filter(Boolean),o=h=>n.map((f,u)=>n[(h+u)%n.length]),a=n.findIndex((h,f)=>r.every(u=>!ew(u,o(f)))),l=o(Math.max(0,a)),c=n.length-2;for(let h=1;h<=c;++h){let f=1|(h===c?2:0)|(h===1?4:0);e=$c(i,e,l[0],l[h],l[h+1],8*s+f)}return e}function ew(i,e){let t=r=>[0,1,2].map(o=>i[4*r+o]-i[4*e[0]+o]),n=[];for(let r=1;r+1<e.length;++r){let[o,a]=[t(e[r]),t(e[r+1])];n.push([o[1]*a[2]-o[2]*a[1],o[2]*a[0]-o[0]*a[2],o[0]*a[1]-o[1]*a[0]])}let s=[0,1,2].map(r=>n.reduce((o,a)=>o+a[r],0));return n.some(r=>r[0]*s[0]+r[1]*s[1]+r[2]*s[2]<0)}function bg(i,e,t,n,s){let r=(M,p)=>i[4*M+p]-i[4*e+p],[o,a,l]=[r(t,0),r(t,1),r(t,2)],[c,h,f]=[r(n,0),r(n,1),r(n,2)],[u,d,g]=[r(s,0),r(s,1),r(s,2)];return(a*f-l*h)*(h*g-f*d)+(l*c-o*f)*(f*u-c*g)+(o*h-a*c)*(c*d-h*u)<0}function $c(i,e,t,n,s,r){return i[e]=t,i[e+2]=n,i[e+4]=s,i[e+1]=i[e+3]=i[e+5]=r,e+6}function tw(i,e,t,n){let s=new Int32Array(4*e.count),r=0,o=(a,l)=>{s[r++]=a,s[r++]=l};for(let a=0;a<e.count;++a){let l=e.cell[a],c=e.other[a],h=t[l]>0,f=c>=0&&t[c]>0;h&&f?n?(o(l,e.side[a]),o(c,e.otherSide[a])):ii[i.kind[c]].volume||o(l,e.side[a]):h?o(l,e.side[a]):f&&o(c,e.otherSide[a])}return s.subarray(0,r)}function pf(i){return i.minFilter=i.magFilter=Qt,i.generateMipmaps=!1,i.needsUpdate=!0,i}function Ag(i){return pf(new ws(i,zs,i.length/4/zs,Pn,Zn))}var Zc=class{constructor(e){this.mesh=e,this.points=new Map,this.middles=new Map}ofPoints(e){return this.#e(this.points,e,()=>Ag(e))}ofMiddles(e){return this.#e(this.middles,e,()=>Ag(Ra(this.mesh,e)))}#e(e,t,n){let s=e.get(t)??n();e.delete(t),e.set(t,s);let[r]=e.keys();return e.size>6&&(e.get(r).dispose(),e.delete(r)),s}dispose(){for(let e of[this.points,this.middles])for(let t of e.values())t.dispose()}};function Tg(i){let e=new Uint8Array(4*Ea(i)),t=new ws(e,zs,e.length/4/zs,Jr,bn);return t.internalFormat="RGBA8UI",pf(t)}function Eg(){return pf(new ws(Lp(),256,1,Pn,bn))}var ur=`precision highp float;
precision highp int;
precision highp usampler2D;
`,mf=`
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform highp sampler2D beforePoints;
uniform highp sampler2D fromPoints;
uniform highp sampler2D toPoints;
uniform float mixing;
ivec2 texel(uint i) { return ivec2(int(i & 2047u), int(i >> 11u)); }
vec3 pointOf(uint vertex) {
  ivec2 at = texel(vertex);
  vec3 from = texelFetch(fromPoints, at, 0).xyz;
  return mixing == 0.0 ? from : mix(from, texelFetch(toPoints, at, 0).xyz, mixing);
}
`,gf=`${ur}${mf}
in uvec2 corner;  // vertex; 8 cell + edges
uniform highp sampler2D fromMiddles;
uniform highp sampler2D toMiddles;
uniform float shrink;
uniform usampler2D cells;  // byte before, byte after, visibility, unused
uniform sampler2D colours;
uniform float progress;    // 0: values before, 1: values after
uniform bool lowerIsBetter;
uniform vec3 fadedColour;
uniform vec3 plainColour;
uniform bool hasValues;
uniform bool planar;
out vec3 viewPoint;
out vec3 weights;
flat out vec3 colour;
flat out uint edges;
flat out int cell;
flat out int look;         // 1: value, 2: faded, 3: undefined

void main() {
  uint number = corner.y >> 3u;
  uvec4 data = texelFetch(cells, texel(number), 0);
  cell = int(number);
  edges = corner.y & 7u;
  look = int(data.b);
  int k = gl_VertexID % 3;
  weights = vec3(k == 0, k == 1, k == 2);
  if (data.b == 0u) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec3 point = pointOf(corner.x);
  if (shrink < 1.0) {
    ivec2 at = texel(number);
    vec3 middle = mix(texelFetch(fromMiddles, at, 0).xyz, texelFetch(toMiddles, at, 0).xyz, mixing);
    point = mix(middle, point, shrink);
  }
  vec4 seen = modelViewMatrix * vec4(point, 1.0);
  viewPoint = seen.xyz;
  gl_Position = projectionMatrix * seen;

  uint nearest = progress < 0.5 ? data.r : data.g;
  float value = data.r == 255u || data.g == 255u ? float(nearest) : mix(float(data.r), float(data.g), progress);
  float good = value / 254.0;
  if (lowerIsBetter) good = 1.0 - good;
  colour = hasValues ? texelFetch(colours, ivec2(int(good * 255.0 + 0.5), 0), 0).rgb : plainColour;
  if (look == 1 && hasValues && nearest == 255u) look = 3;
  if (look == 2) colour = fadedColour;
  // Cells that lie on each other in a plane: the worst on top, or those turned over would be hidden.
  if (planar && look != 2) gl_Position.z -= look == 3 ? 3e-4 : 2e-4 * (1.0 - good);
}`,Cg=`${ur}
in vec3 viewPoint;
in vec3 weights;
flat in vec3 colour;
flat in uint edges;
flat in int cell;
flat in int look;
uniform float shading;
uniform bool showEdges;
uniform float pixelRatio;
uniform vec3 edgeColour;
uniform vec3 undefinedColour;
uniform vec3 undefinedStripe;
uniform int hovered;
out vec4 fragment;

void main() {
  vec3 base = colour;
  if (look == 3) {
    float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 8.0 * pixelRatio) / pixelRatio;
    base = stripe < 2.5 ? undefinedStripe : undefinedColour;
  }
  vec3 normal = cross(dFdx(viewPoint), dFdy(viewPoint));
  float size = length(normal);
  vec3 light = normalize(vec3(-0.25, 0.45, 1.0));
  float lit = size > 0.0 ? abs(dot(normal / size, light)) : 1.0;
  base *= mix(1.0, 0.6 + 0.42 * lit, shading);
  if (cell == hovered) base = mix(base, vec3(1.0), 0.3);

  if (showEdges) {
    vec3 slope = sqrt(dFdx(weights) * dFdx(weights) + dFdy(weights) * dFdy(weights));
    vec3 steep = max(slope, vec3(1e-9));
    vec3 away = weights / steep;
    bvec3 real = bvec3(edges & 1u, edges & 2u, edges & 4u);
    away = mix(vec3(1e9), away, real);
    float nearest = min(away.x, min(away.y, away.z)) / pixelRatio;
    float line = 1.0 - smoothstep(0.35, 1.15, nearest);
    // Where cells are hardly larger than the lines, lines would hide the colours.
    float height = 1.0 / (max(steep.x, max(steep.y, steep.z)) * pixelRatio);
    float strength = clamp((height - 2.0) / 9.0, 0.0, 1.0) * (look == 2 ? 0.28 : 0.8);
    base = mix(base, edgeColour, line * strength);
  }
  fragment = vec4(base, 1.0);
}`,Rg=`${ur}
flat in int cell;
out vec4 fragment;
void main() {
  uint n = uint(cell + 1);
  fragment = vec4(n & 255u, (n >> 8u) & 255u, (n >> 16u) & 255u, n >> 24u) / 255.0;
}`,Ig=`${ur}${mf}
in uvec2 ends;
uniform bool arrows;
uniform float arrowScale;
uniform vec2 viewport;     // in pixels
uniform float width;       // in pixels
uniform float lift;        // towards the eye, in depth
const vec2 shaft[6] = vec2[6](vec2(0, -1), vec2(1, -1), vec2(1, 1), vec2(0, -1), vec2(1, 1), vec2(0, 1));
void main() {
  vec3 a, b;
  if (arrows) {
    a = texelFetch(beforePoints, texel(ends.x), 0).xyz;
    b = a + arrowScale * (pointOf(ends.x) - a);
  } else {
    a = pointOf(ends.x);
    b = pointOf(ends.y);
  }
  vec4 p = projectionMatrix * modelViewMatrix * vec4(a, 1.0);
  vec4 q = projectionMatrix * modelViewMatrix * vec4(b, 1.0);
  vec2 along = (q.xy - p.xy) * 0.5 * viewport;
  float size = length(along);
  vec2 direction = size > 1e-6 ? along / size : vec2(1.0, 0.0);
  vec2 across = vec2(-direction.y, direction.x);
  int k = gl_VertexID;
  vec2 offset;             // in pixels from p
  float place;
  if (arrows) {
    float tip = min(0.5 * size, 4.5 * width);
    if (k < 6) {
      place = shaft[k].x;
      offset = direction * place * (size - tip) + across * shaft[k].y * 0.5 * width;
    } else {
      place = 1.0;
      float side = k == 6 ? -1.0 : k == 7 ? 1.0 : 0.0;
      offset = direction * (size - (k == 8 ? 0.0 : tip)) + across * side * 0.45 * tip;
    }
  } else {
    place = shaft[k].x;
    // A little longer than the edge, so that bends have no gaps.
    offset = direction * (place * size + (2.0 * place - 1.0) * 0.4 * width) + across * shaft[k].y * 0.5 * width;
  }
  vec2 at = p.xy + offset * 2.0 / viewport;
  gl_Position = vec4(at, mix(p.z, q.z, place) - lift, 1.0);
}`,Pg=`${ur}
uniform vec3 colour;
out vec4 fragment;
void main() { fragment = vec4(colour, 1.0); }`,Lg=`${ur}${mf}
in uvec2 mark;             // vertex, hold
uniform float pixelRatio;
uniform float lift;
flat out uint hold;
void main() {
  hold = mark.y;
  vec4 at = projectionMatrix * modelViewMatrix * vec4(pointOf(mark.x), 1.0);
  gl_Position = vec4(at.xy, at.z - lift, 1.0);
  gl_PointSize = 9.0 * pixelRatio;
}`,Dg=`${ur}
flat in uint hold;
uniform vec3 holdColours[6];
uniform vec3 rim;
out vec4 fragment;
void main() {
  vec2 p = 2.0 * gl_PointCoord - 1.0;
  float d;
  if (hold == 1u) d = max(abs(p.x), abs(p.y)) + 0.2;
  else if (hold == 4u) d = abs(p.x) + abs(p.y);
  else if (hold == 5u) d = max(p.y + 0.25, abs(p.x) * 1.2 - p.y * 0.6 - 0.1) + 0.25;
  else d = length(p) + 0.05;
  if (d > 1.0) discard;
  vec3 inside = hold == 3u && d < 0.45 ? rim : holdColours[hold];
  fragment = vec4(d > 0.78 ? rim : inside, 1.0);
}`;function iw(i){return i.cellCount<5e4||!sw()}function sw(){let i=document.createElement("canvas").getContext("webgl2");if(!i)return!0;let e=i.getParameter(i.RENDERER);if(/^WebKit/.test(e)){let t=i.getExtension("WEBGL_debug_renderer_info");t&&(e=i.getParameter(t.UNMASKED_RENDERER_WEBGL))}return i.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(e)}function rw(i,e){let t=i.getContext("webgl2",{antialias:iw(e)});if(!t)throw new ds("The interactive view needs WebGL 2, which this browser does not offer.");return t}var yi=i=>new Z(...i).divideScalar(255),Jc=class{constructor(e,t){this.mesh=t,this.canvas=e,this.renderer=new Ac({canvas:e,context:rw(e,t)}),this.renderer.autoClear=!1,this.textures=new Zc(t),this.cells=Tg(t.cellCount),this.uniforms=this.#e(),this.scene=new Hr,this.numbersScene=new Hr,this.numbers=new Rn(1,1,{samples:0}),this.numbersFresh=!1,this.#o(),this.lines=this.#n(2.2,6,4e-4),this.arrows=this.#n(1.7,9,8e-4,{arrows:{value:!0}}),this.outlines=[this.#n(6,6,0),this.#n(2.6,6,0)];for(let n of this.outlines)n.material.depthTest=!1,n.renderOrder=3;this.marks=this.#s()}#e(){let e=t=>({value:t});return{beforePoints:e(this.textures.ofPoints(this.mesh.before)),fromPoints:e(null),toPoints:e(null),fromMiddles:e(null),toMiddles:e(null),mixing:e(0),progress:e(0),shrink:e(1),cells:e(this.cells),colours:e(Eg()),lowerIsBetter:e(!1),hasValues:e(!1),shading:e(this.mesh.dimension===2?0:1),planar:e(this.mesh.dimension===2),showEdges:e(!0),pixelRatio:e(1),viewport:e(new Mt),hovered:e(-1),edgeColour:e(new Z),fadedColour:e(new Z),plainColour:e(new Z),rim:e(new Z),undefinedColour:e(yi(no)),undefinedStripe:e(yi(Ic)),arrowScale:e(1),holdColours:e(Array.from({length:6},()=>new Z))}}#t(e,t,n={}){return new Xr({glslVersion:ea,vertexShader:e,fragmentShader:t,side:2,uniforms:{...this.uniforms,...n}})}#o(){let e=new _n;this.body=new Mn(e,this.#t(gf,Cg)),this.numbersBody=new Mn(e,this.#t(gf,Rg));for(let t of[this.body,this.numbersBody])t.frustumCulled=!1;this.scene.add(this.body),this.numbersScene.add(this.numbersBody)}#n(e,t,n,s={}){let r=this.#t(Ig,Pg,{colour:{value:new Z},width:{value:e},lift:{value:n},arrows:{value:!1},...s}),o=new Mn(new qr,r);return o.userData={corners:t,width:e},o.frustumCulled=!1,o.visible=!1,o.renderOrder=1,this.scene.add(o),o}#s(){let e=new Vo(new _n,this.#t(Lg,Dg,{lift:{value:.001}}));return e.frustumCulled=!1,e.visible=!1,e.renderOrder=2,this.scene.add(e),e}setTheme(e){let{uniforms:t}=this;this.clearColour=new ft(`rgb(${e.canvas.join(",")})`),this.renderer.setClearColor(this.clearColour),t.edgeColour.value=yi(e.edge),t.fadedColour.value=yi(e.faded),t.plainColour.value=yi(e.plain),t.rim.value=yi(e.rim),t.holdColours.value=e.holds.map(yi),this.lines.material.uniforms.colour.value=yi(e.feature),this.arrows.material.uniforms.colour.value=yi(e.arrow),this.outlines[0].material.uniforms.colour.value=yi([15,18,24]),this.outlines[1].material.uniforms.colour.value=yi([255,255,255])}setMetric(e){let{data:t}=this.cells.image;for(let n=0;n<this.mesh.cellCount;++n)t[4*n]=e?e.before[n]:0,t[4*n+1]=e?e.after[n]:0;this.cells.needsUpdate=!0,this.uniforms.hasValues.value=!!e,this.uniforms.lowerIsBetter.value=e?.better==="lower"}setVisible(e,t){let{data:n}=this.cells.image;for(let o=0;o<this.mesh.cellCount;++o)n[4*o+2]=e.of[o];this.cells.needsUpdate=!0,this.numbersFresh=!1;let s=this.mesh.type==="volume";if(this.faces&&!s)return;this.faces??=Sg(this.mesh);let r=s?e.of:new Uint8Array(this.mesh.cellCount).fill(1);this.#a(wg(this.mesh,this.faces,r,s&&t))}onBoundary(e){let{faces:t}=this;for(let n=0;n<t.count;++n)if(t.other[n]<0&&t.cell[n]===e)return!0;return!1}#a(e){let t=new _n;t.setAttribute("corner",new mn(e,2)),t.setDrawRange(0,e.length/2),t.boundingSphere=new es(new Z,1/0),this.body.geometry.dispose(),this.body.geometry=this.numbersBody.geometry=t,this.body.visible=this.numbersBody.visible=e.length>0}#i(e,t){let n=new qr;n.setAttribute("ends",new ko(Uint32Array.from(t),2)),n.instanceCount=t.length/2,n.setDrawRange(0,e.userData.corners),e.geometry.dispose(),e.geometry=n,e.userData.count=t.length/2}setFeatureEdges(e){this.#i(this.lines,e??[])}setArrows(e){let{mesh:t}=this,n=mh(t,e),s=1e-7*t.box.diagonal,r=[];for(let o=0;o<t.vertexCount;++o){if(!n[o])continue;let a=4*o;Math.abs(t.after[a]-t.before[a])+Math.abs(t.after[a+1]-t.before[a+1])+Math.abs(t.after[a+2]-t.before[a+2])>s&&r.push(o,o)}this.#i(this.arrows,r)}setMarks(e,t){let n=mh(this.mesh,e),s=[];for(let o=0;o<t.length;++o)n[o]&&t[o]>0&&t[o]<6&&s.push(o,t[o]);let r=new _n;r.setAttribute("mark",new mn(Uint32Array.from(s),2)),r.setDrawRange(0,s.length/2),this.marks.geometry.dispose(),this.marks.geometry=r,this.marks.userData.count=s.length/2}setSelected(e){let{mesh:t}=this,n=e<0?[]:Aa(t,e).flatMap(s=>s.map(r=>t.vertices[t.first[e]+r]));for(let s of this.outlines)this.#i(s,n),s.visible=e>=0}setLook(e){let{uniforms:t}=this;t.showEdges.value=e.edges,t.hovered.value=e.hovered,t.arrowScale.value=e.vectorScale,t.shrink.value=e.shrink,this.lines.visible=e.features&&this.lines.userData.count>0,this.marks.visible=e.marks&&this.marks.userData.count>0,this.arrows.visible=e.vectors&&this.arrows.userData.count>0}resize(e,t,n){this.renderer.setPixelRatio(n),this.renderer.setSize(e,t,!1),this.uniforms.pixelRatio.value=n,this.numbers.setSize(Math.max(1,e),Math.max(1,t))}render(e,t,n){let{renderer:s}=this;s.setRenderTarget(null),s.setScissorTest(!0);for(let r of e){let{viewport:o,scissor:a}=r;a.width<1||a.height<1||(this.#r(r),s.setViewport(o.x,n-o.y-o.height,o.width,o.height),s.setScissor(a.x,n-a.y-a.height,a.width,a.height),s.clear(),s.render(this.scene,t.cameraFor(o.width/o.height)))}this.numbersFresh=!1}#r({viewport:e,from:t,to:n,mixing:s,progress:r}){let{uniforms:o,textures:a}=this,l=o.pixelRatio.value;o.fromPoints.value=a.ofPoints(t),o.toPoints.value=a.ofPoints(n),o.shrink.value<1&&(o.fromMiddles.value=a.ofMiddles(t),o.toMiddles.value=a.ofMiddles(n)),o.mixing.value=s,o.progress.value=r,o.viewport.value.set(e.width*l,e.height*l);for(let c of[this.lines,this.arrows,...this.outlines])c.material.uniforms.width.value=c.userData.width*l}pick(e,t,n,s){let{renderer:r,numbers:o}=this;if(!this.numbersFresh){r.setClearColor(0,0);for(let l of e){let{viewport:c,scissor:h}=l;h.width<1||h.height<1||(this.#r(l),o.viewport.set(c.x,o.height-c.y-c.height,c.width,c.height),o.scissor.set(h.x,o.height-h.y-h.height,h.width,h.height),o.scissorTest=!0,r.setRenderTarget(o),r.clear(),r.render(this.numbersScene,t.cameraFor(c.width/c.height)))}r.setRenderTarget(null),r.setClearColor(this.clearColour,1),this.numbersFresh=!0}if(n<0||s<0||n>=o.width||s>=o.height)return-1;let a=new Uint8Array(4);return r.readRenderTargetPixels(o,Math.floor(n),o.height-1-Math.floor(s),1,1,a),(a[0]|a[1]<<8|a[2]<<16|a[3]<<24)-1}finish(){let e=this.renderer.getContext();e.readPixels(0,0,1,1,e.RGBA,e.UNSIGNED_BYTE,new Uint8Array(4))}dispose(){for(let e of[this.body,this.numbersBody,this.lines,this.arrows,this.marks,...this.outlines])e.geometry.dispose(),e.material.dispose();this.cells.dispose(),this.uniforms.colours.value.dispose(),this.textures.dispose(),this.numbers.dispose(),this.renderer.dispose()}};var Kc=class{constructor(e,t){this.mesh=e,this.store=t,this.canvas=z("canvas",{tabindex:"0",class:"em-canvas",role:"application","aria-label":"Picture of the mesh. Arrow keys turn or shift it, plus and minus zoom, question mark lists all keys."}),this.scene=new Jc(this.canvas,e),this.view=new Cc(e,()=>this.redraw()),this.labels=[z("div",{class:"em-label"}),z("div",{class:"em-label"})],this.handle=this.#e(),this.tip=z("div",{class:"em-tip",hidden:!0}),this.triad=e.dimension===3&&uw(),this.divider=z("div",{class:"em-divider",hidden:!0}),this.element=z("div",{class:"em-stage"},this.canvas,this.divider,...this.labels,this.handle,this.triad&&this.triad.element,this.tip),this.size={width:0,height:0},this.drawn=0,this.points={from:e.before,to:e.before,mixing:0},this.#t(),this.observer=new ResizeObserver(()=>this.#n()),this.observer.observe(this.canvas)}#e(){let e=n=>this.store.set({wipe:Math.min(.98,Math.max(.02,n))}),t=z("div",{class:"em-wipe",role:"slider",tabindex:"0","aria-label":"Border between before and after","aria-valuemin":"0","aria-valuemax":"100",hidden:!0,onpointerdown:n=>t.setPointerCapture(n.pointerId),onpointermove:n=>{if(!t.hasPointerCapture(n.pointerId))return;let s=this.canvas.getBoundingClientRect();e((n.clientX-s.left)/s.width)},onkeydown:n=>{let s={ArrowLeft:-.02,ArrowRight:.02}[n.key];s&&(e(this.store.get().wipe+s),n.preventDefault(),n.stopPropagation())}},z("span",{"aria-hidden":"true"},"\u21D4"));return t}#t(){let{store:e}=this;xg(this.canvas,this.view,{paneAt:(t,n)=>Mg(this.panes,t,n),hover:(t,n)=>{this.hoverAt=[t,n],this.hoverFrame??=requestAnimationFrame(()=>this.#i())},leave:()=>{this.hoverAt=null,e.set({hovered:-1})},click:(t,n)=>e.set({selected:this.pick(t,n)})}),this.canvas.addEventListener("dblclick",()=>{let{selected:t}=e.get();t>=0&&this.goTo(t)}),this.unsubscribe=[e.on(["mode","wipe","visible","values","edges","features","marks","vectors","vectorScale","shrink"],()=>this.redraw()),e.on(["mode"],()=>this.#s()),e.on(["scrub"],({scrub:t})=>this.#o(t)),e.on(["selected"],({selected:t})=>{this.scene.setSelected(t),this.redraw()}),e.on(["hovered"],({hovered:t})=>{this.#r(t),this.redraw()})]}async#o(e){let{stops:t}=this.mesh,n=Math.min(Math.floor(e),t.length-1),s=Math.min(n+1,t.length-1),r=await Promise.all([t[n].points(),t[s].points()]);this.store.get().scrub===e&&(this.points={from:r[0],to:r[1],mixing:e-n},this.redraw())}#n(){let e=this.canvas.clientWidth,t=this.canvas.clientHeight;e<1||t<1||(this.size={width:e,height:t},this.scene.resize(e,t,Math.min(window.devicePixelRatio||1,2)),this.#s(),this.draw())}#s(){this.size.width&&(this.view.aspect=yg(this.store.get(),this.size),this.view.fitted&&this.view.fit())}get panes(){let e=this.store.get(),t=this.mesh.stops.length-1,n=t>0?e.scrub/t:0,{before:s}=this.mesh;return vg(e,this.size,{from:s,to:s,mixing:0,progress:0,label:"before"},{...this.points,progress:n,label:ow(this.mesh.stops,e.scrub)})}redraw(){this.frame??=requestAnimationFrame(()=>this.draw())}draw(){this.frame!==void 0&&cancelAnimationFrame(this.frame),this.frame=void 0;let e=this.store.get();!this.size.width||!e.visible||(this.scene.setLook(e),this.scene.render(this.panes,this.view,this.size.height),this.#a(e),++this.drawn,this.whenDrawn?.())}#a({mode:e,wipe:t}){let{panes:n,mesh:s}=this;this.labels.forEach((r,o)=>{let a=n[o];if(r.hidden=!a||s.stops.length===1,r.hidden)return;r.textContent=a.label;let l=e==="wipe"&&o===1;r.classList.toggle("em-right",l),r.style.left=l?"":`${a.scissor.x+12}px`,r.style.top=`${a.scissor.y+12}px`}),this.handle.hidden=e!=="wipe",this.handle.style.left=`${t*100}%`,this.handle.setAttribute("aria-valuenow",Math.round(t*100)),this.divider.hidden=e!=="side",this.divider.classList.toggle("em-flat",this.size.width<this.size.height),this.triad?.turn?.(this.view.axes())}pick(e,t){return!this.size.width||!this.store.get().visible?-1:(this.frame!==void 0&&this.draw(),this.scene.pick(this.panes,this.view,e,t))}#i(){this.hoverFrame=void 0,this.hoverAt&&this.store.set({hovered:this.pick(...this.hoverAt)}),this.#l()}async#r(e){if(this.tip.hidden=e<0,e<0)return;let{values:t}=this.store.get(),{cellName:n}=await this.mesh.details();if(this.store.get().hovered!==e)return;let s=t&&`${Jn(t.name)} ${oa(t,t.before[e])}`+(this.mesh.after?` \u2192 ${oa(t,t.after[e])}`:"");this.tip.replaceChildren(...[z("strong",null,`${ii[this.mesh.kind[e]].name} ${n(e)}`),s&&z("span",null,s)].filter(Boolean)),this.#l()}#l(){if(!this.hoverAt||this.tip.hidden)return;let[e,t]=this.hoverAt,{offsetWidth:n,offsetHeight:s}=this.tip;this.tip.style.left=`${Math.max(4,Math.min(e+14,this.size.width-n-6))}px`,this.tip.style.top=`${t+18+s>this.size.height?t-s-10:t+18}px`}goTo(e){let{mesh:t,view:n}=this,s=t.after??t.before,r=Tr(t,s,e),o={target:r,halfHeight:Math.min(7*aw(t,s,e),.5*n.whole().halfHeight)};if(t.dimension===3){let a=t.type==="volume"?jc(t,r):cw(t,s,e),{eye:l}=n.axes(),c=t.type!=="volume"&&_a(a,l)<0&&!hw(t,r,a);Object.assign(o,Rc(a.map(h=>c?-h:h)))}n.fly(o)}cutTo(e){if(this.scene.onBoundary(e))return{cutAxis:"off"};let t=Tr(this.mesh,this.mesh.before,e),n=jc(this.mesh,t),[s,r]=Pa(this.mesh,n),o=r>s?(_a(t,n)-s)/(r-s):1;return{cutAxis:"view",cutNormal:n,cutPlace:Math.min(1,o+1e-4),cutFlip:!1}}project(e,t="after"){let{panes:n,view:s,mesh:r}=this,o=n.length===1||t==="after"?n.at(-1):n[0],[a,l]=[o.from,o.to].map(m=>Tr(r,m,e)),c=a.map((m,y)=>m+(l[y]-m)*o.mixing-s.target[y]),{right:h,up:f}=s.axes(),{x:u,y:d,width:g,height:M}=o.viewport,p=M/2/s.halfHeight;return{x:u+g/2+_a(c,h)*p,y:d+M/2-_a(c,f)*p}}snapshot(){this.draw();let e=this.canvas.width/this.size.width,{values:t}=this.store.get(),n=t?34:0,s=z("canvas",{width:this.canvas.width,height:this.canvas.height+n*e}),r=s.getContext("2d");r.drawImage(this.canvas,0,0),r.scale(e,e),t&&gg(r,t,{y:this.size.height,width:this.size.width,height:n},getComputedStyle(this.element)),r.font="600 13px system-ui, sans-serif";for(let o of this.labels){if(o.hidden)continue;let a=getComputedStyle(o),{offsetLeft:l,offsetTop:c,offsetWidth:h,offsetHeight:f}=o;r.fillStyle=a.backgroundColor,r.fillRect(l,c,h,f),r.fillStyle=a.color,r.textBaseline="middle",r.fillText(o.textContent,l+9,c+f/2+1)}return s}dispose(){this.observer.disconnect(),this.view.stop(),this.frame!==void 0&&cancelAnimationFrame(this.frame);for(let e of this.unsubscribe)e();this.scene.dispose()}},_a=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2];function ow(i,e){let t=Math.round(e);if(Math.abs(e-t)<1e-6)return i[t].label;let n=Math.floor(e);return`${i[n].label} \u2192 ${i[n+1].label}, ${Math.round(100*(e-n))} %`}function aw(i,e,t){let n=i.first[t],s=Aa(i,t).map(([r,o])=>{let a=4*i.vertices[n+r],l=4*i.vertices[n+o];return Math.hypot(e[a]-e[l],e[a+1]-e[l+1],e[a+2]-e[l+2])});return Math.max(...s,1e-5*i.box.diagonal)}function lw({low:i,high:e}){return i.map((t,n)=>(t+e[n])/2)}function jc(i,e){let t=lw(i.box),n=e.map((r,o)=>r-t[o]),s=Math.hypot(...n);return s>1e-6*i.box.diagonal?n.map(r=>r/s):[.5,-.8,.6]}function cw(i,e,t){let[n,s,r]=[0,1,2].map(h=>4*i.vertices[i.first[t]+h]),o=[0,1,2].map(h=>e[s+h]-e[n+h]),a=[0,1,2].map(h=>e[r+h]-e[n+h]),l=[o[1]*a[2]-o[2]*a[1],o[2]*a[0]-o[0]*a[2],o[0]*a[1]-o[1]*a[0]],c=Math.hypot(...l);return c>0?l.map(h=>h/c):jc(i,[e[n],e[n+1],e[n+2]])}function hw(i,e,t){return _a(t,jc(i,e))>.2}function uw(){let i=["x","y","z"].map(t=>({line:qt("line",{x1:0,y1:0,class:`em-axis em-axis-${t}`}),text:qt("text",{class:`em-axis-name em-axis-${t}`},t)}));return{element:qt("svg",{viewBox:"-34 -34 68 68",class:"em-triad","aria-hidden":"true"},...i.flatMap(({line:t,text:n})=>[t,n])),turn({right:t,up:n}){i.forEach(({line:s,text:r},o)=>{let a=t[o],l=-n[o];s.setAttribute("x2",20*a),s.setAttribute("y2",20*l),r.setAttribute("x",28*a),r.setAttribute("y",28*l+4)})}}}var fw={pass:"\u2713",fail:"\u2717",none:"\u2013"},dw={pass:"pass",fail:"fail",none:"not judged"},pw=i=>i===!0?"pass":i===!1?"fail":"none";function Ng(i){return z("section",{class:"em-summary","aria-label":"Result"},z("div",{class:"em-card em-result"},mw(i),_w(i.verdicts??[])),i.ledger?.length>0&&z("div",{class:"em-card"},z("h2",null,"Geometry"),z("dl",{class:`em-columns ${i.ledger.length>6?"em-two":""}`},...i.ledger.map(({name:e,value:t})=>z("div",null,z("dt",null,e),z("dd",null,t))))),xw(i))}function mw({run:i,status:e=i?.status,message:t=i?.message,verdicts:n=[],kind:s}){let r=n.filter(({pass:c})=>c===!1).length,o=gw(e,r),a=e??(r?"not passed":s==="check"?"checked":"compared"),l=t??(r?`${r} of ${n.length} checks did not pass`:n.some(({pass:c})=>c===!0)?"All that was judged passed":"Measured; nothing was judged");return z("p",{class:"em-headline"},z("span",{class:`em-status em-${o}`},a)," ",l)}function gw(i,e){return i?i==="failed"?"fail":i==="ok"&&!e?"pass":"warn":e?"fail":"pass"}function _w(i){return i.length===0?null:z("ul",{class:"em-verdicts"},...i.map(({name:e,pass:t,text:n})=>{let s=pw(t);return z("li",{class:`em-verdict-${s}`},z("span",{class:"em-mark",role:"img","aria-label":dw[s]},fw[s]),z("span",{class:"em-verdict-name"},e),z("span",{class:"em-verdict-text"},n))}))}function xw({notes:i=[],mesh:e}){let t=[...i],{shown:n,of:s}=e?.cells??{};return n<s&&t.unshift(`${eo(n)} of ${eo(s)} cells are in this file and can be looked at.`),t.length===0?null:z("div",{class:"em-card"},z("h2",null,"Notes"),z("ul",{class:"em-notes"},...t.map(r=>z("li",null,r))))}var Fg={light:{canvas:[247,248,250],edge:[22,28,38],faded:[222,226,232],plain:[150,170,196],rim:[255,255,255],feature:[10,14,22],arrow:[214,72,4],holds:[[0,0,0],[30,36,48],[0,98,196],[0,98,196],[124,58,190],[201,78,0]]},dark:{canvas:[20,23,29],edge:[8,10,14],faded:[58,64,75],plain:[104,124,152],rim:[255,255,255],feature:[232,236,242],arrow:[255,146,60],holds:[[0,0,0],[30,36,48],[0,98,196],[0,98,196],[124,58,190],[201,78,0]]}};function Ug(i,e){let t=matchMedia("(prefers-color-scheme: dark)"),n=null,s=()=>n??(t.matches?"dark":"light"),r=z("button",{type:"button",class:"em-button",onclick:()=>{n=s()==="dark"?"light":"dark",o()}}),o=()=>{i.dataset.theme=s(),r.textContent=s()==="dark"?"Light":"Dark",r.title=`Change to ${s()==="dark"?"light":"dark"} colours (T)`,e(Fg[s()])};t.addEventListener("change",o);let a=l=>getComputedStyle(i).getPropertyValue(l).trim();return{button:r,apply:o,name:s,chart:()=>({accent:a("--accent"),muted:a("--muted"),grid:a("--grid")}),palette:()=>Fg[s()],dispose:()=>t.removeEventListener("change",o)}}function Og({worst:i=[],mesh:e},t,n){if(i.length===0)return null;let s=e.has_after,r=i.map(o=>vw(o,s,n));return t.on(["selected"],({selected:o})=>{i.forEach(({cell:a},l)=>r[l].classList.toggle("em-chosen",a>=0&&a===o))}),z("section",{class:"em-card em-worst"},z("h2",null,"Worst cells"),z("p",{class:"em-hint"},"Choose one to see it. N and P go through the list."),z("div",{class:"em-scroll em-list"},z("table",{class:"em-table"},z("thead",null,z("tr",null,z("th",{scope:"col"},"cell"),z("th",{scope:"col"},"kind"),z("th",{scope:"col",class:"em-number"},s?"shape before":"shape"),s&&z("th",{scope:"col",class:"em-number"},"after"),z("th",{scope:"col"},"what holds it"))),z("tbody",null,...r))))}function vw(i,e,t){let n=i.cell>=0,s=n?z("button",{type:"button",class:"em-link"},i.name):z("span",{title:"Not among the cells in this file"},i.name);return z("tr",{class:n?"em-goes":null,onclick:n&&(()=>t(i.cell))},z("th",{scope:"row"},s,i.inverted&&z("span",{class:"em-tag"},"inverted")),z("td",null,i.kind),z("td",{class:"em-number"},Vt(i.shape_before)),e&&z("td",{class:"em-number"},Vt(i.shape_after)),z("td",{class:"em-holds"},(i.held_by??[]).join("; ")||"\u2013"))}var Bg=1,yw={smooth:"Smoothing",compare:"Comparison",check:"Check"};async function kg(i,e,t,{keyTarget:n=i}={}){if(e.format!==Bg)throw new ds(`This report has data format ${e.format}; this page reads format ${Bg}.`);let s=await Vf(e,kf(e.arrays??{},t)),r=$f(Zf(s));r.get().metric&&r.set({values:await s.metric(r.get().metric)}),performance.mark("evenmesh-decoded");let o,a=()=>l.palette(),l=Ug(i,A=>{o?.scene.setTheme(A),o?.redraw(),c?.redraw(),g?.redraw()}),c=mg(r,a);o=new Kc(s,r);let h=(e.worst??[]).map(({cell:A})=>A).filter(A=>A>=0&&A<s.cellCount),f=Aw({report:e,mesh:s,store:r,stage:o,theme:l,listed:h,dialog:()=>d}),u=fg({mesh:s,store:r,stage:o,actions:f}),d=pg(u),g=hg(e.history,l.chart),M={bar:Cp(s,r,f),cell:Ip(e,s,r,o.goTo.bind(o)),controls:Up(s,r,f)},p=bw(e,s,r,o,h),m=new Promise(A=>{o.whenDrawn=A});i.classList.add("em-app"),i.replaceChildren(Mw(e,l),z("main",null,Ng(e),z("section",{class:"em-workspace","aria-label":"Mesh"},z("div",{class:"em-picture"},M.bar.element,o.element,c.element),z("aside",{class:"em-side","aria-label":"Cell, colours and filters"},M.cell.element,...M.controls.panels)),z("div",{class:"em-below"},...[Og(e,r,f.goTo),_g(e.quality),g?.element,Pp(e)].filter(Boolean))),d),i.hidden=!1,l.apply();let y=dg(n,u,o.canvas);return await m,o.whenDrawn=void 0,o.scene.finish(),{state:()=>Tw(r.get(),s),set:A=>r.set(A),select:A=>r.set({selected:A}),goTo:f.goTo,project:(A,w)=>o.project(A,w),pick:(A,w)=>o.pick(A,w),camera:()=>({target:[...o.view.target],halfHeight:o.view.halfHeight,azimuth:o.view.azimuth,elevation:o.view.elevation,flying:o.view.flying}),settled:()=>Ew(o),redraw(){o.draw(),o.scene.finish()},snapshot:()=>o.snapshot().toDataURL("image/png"),canvas:o.canvas,dispose(){p(),y(),l.dispose(),c.dispose(),g?.dispose();for(let A of Object.values(M))A.dispose();o.dispose(),i.replaceChildren()}}}function Mw({title:i,kind:e,program:t},n){return z("header",{class:"em-header"},z("span",{class:"em-brand"},"evenmesh"),z("h1",null,i),z("span",{class:"em-kind"},yw[e]??e,t?z("span",{class:"em-program"},` \xB7 ${t}`):null),n.button)}function bw(i,e,t,n,s){let{scene:r}=n,o=[t.on(["metric"],async({metric:a,values:l})=>{if(!a||l?.name===a)return;let c=await e.metric(a);t.get().metric===a&&t.set({values:c})}),t.on(["values"],({values:a})=>r.setMetric(a)),t.on(["values","range","rangeOf","show","others","cutAxis","cutNormal","cutPlace","cutFlip"],a=>{let l=ww(e,a);t.set({visible:qf(e,a.values,{...a,cut:l},s)})}),t.on(["visible","shrink"],({visible:a,shrink:l})=>{r.setVisible(a,l<1),n.redraw()}),t.on(["visible","marks"],async({marks:a})=>{if(!a)return;let{hold:l}=await e.details();r.setMarks(t.get().visible,l),n.redraw()}),t.on(["visible","vectors"],({visible:a,vectors:l})=>{!l||!e.after||(r.setArrows(a),n.redraw())})];return e.featureEdges().then(a=>{r.setFeatureEdges(a),n.redraw()}),()=>o.forEach(a=>a())}var Sw={x:[1,0,0],y:[0,1,0],z:[0,0,1]};function ww(i,{cutAxis:e,cutNormal:t,cutPlace:n,cutFlip:s}){if(e==="off")return null;let r=(Sw[e]??t).map(c=>s?-c:c),[o,a]=Pa(i,r),l=1e-6*i.box.diagonal;return{normal:r,distance:o+(s?1-n:n)*(a-o)+l}}function Aw({report:i,mesh:e,store:t,stage:n,theme:s,listed:r,dialog:o}){let a=e.stops.length-1,l={blink(){let{mode:h,scrub:f}=t.get();t.set({mode:"single",scrub:h==="single"&&f>a/2?0:h==="single"?a:0})},scrubBy(h){t.set({scrub:Math.min(a,Math.max(0,Math.round((t.get().scrub+h)*100)/100))})},fit:()=>n.view.fly(n.view.whole(),{fitted:!0}),lookAlong(h){let f=Rc(h),{target:u,halfHeight:d}=n.view.whole(f);n.view.fly({...f,target:u,halfHeight:d},{fitted:!0})},goTo(h){t.set({selected:h}),c(h),n.goTo(h),n.element.scrollIntoView({block:"nearest"})},goToSelected(){let{selected:h}=t.get();h>=0&&n.goTo(h)},nextWorst(h){if(r.length===0)return;let f=r.indexOf(t.get().selected),u=f<0?h>0?0:r.length-1:(f+h+r.length)%r.length;l.goTo(r[u])},cut(h){t.set({cutAxis:h,cutNormal:h==="view"?n.view.axes().eye:null,cutFlip:!1})},theme:()=>s.button.click(),keys:()=>o().open?o().close():o().showModal(),save(){z("a",{download:`${i.title.replace(/[^\w.-]+/g,"_")}.png`,href:n.snapshot().toDataURL("image/png")}).click()}};function c(h){e.type==="volume"&&t.set(n.cutTo(h))}return l}function Tw(i,e){let{visible:t,values:n,...s}=i;return{...s,cells:e.cellCount,vertices:e.vertexCount,visibleCells:t?.count??0,decoded:n?.name??null}}async function Ew(i){let e=()=>new Promise(requestAnimationFrame);do await e(),await e();while(i.view.flying||i.frame!==void 0)}performance.mark("evenmesh-start");var xa=document.getElementById("evenmesh-app"),zg=document.getElementById("evenmesh-static");async function Cw(){let i=JSON.parse(document.getElementById("evenmesh-report").textContent),e=Uf(document.getElementById("evenmesh-data").textContent),t=await kg(xa,i,e,{keyTarget:document});return zg?.classList.add("em-print-only"),Rw(t),performance.mark("evenmesh-first-frame"),performance.measure("evenmesh-open",{start:0,end:"evenmesh-first-frame"}),t}function Rw(i){let e=z("img",{class:"em-printed",alt:"The mesh as it was shown on the screen"}),t=z("figure",{class:"em-print-only"},e);document.body.append(t),addEventListener("beforeprint",()=>{e.src=i.snapshot()})}function Iw(i){xa.className="em-app em-failed",xa.replaceChildren(z("p",{class:"em-message",role:"status"},i instanceof ds?i.message:`The interactive view cannot be shown: ${i.message}.`," Below is the report without it.")),xa.hidden=!1,zg?.before(xa)}window.evenmesh={ready:Cw().then(i=>Object.assign(window.evenmesh,i)).catch(i=>{window.evenmesh.error=i.message,Iw(i)})};})();
