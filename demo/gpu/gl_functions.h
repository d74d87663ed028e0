// Which OpenGL functions gl.h loads, by the version that promises them.
//
// X(TYPE, Name): the PFNGL...PROC word of the type, and the name without "gl".
#ifndef TSUYA_DEMO_GPU_GL_FUNCTIONS_H
#define TSUYA_DEMO_GPU_GL_FUNCTIONS_H

// In OpenGL 3.3 core and in OpenGL ES 3.0: always there.
#define GL_FUNCTIONS_COMMON(X)                                                                     \
    X(ACTIVETEXTURE, ActiveTexture)                                                                \
    X(ATTACHSHADER, AttachShader)                                                                  \
    X(BEGINQUERY, BeginQuery)                                                                      \
    X(BEGINTRANSFORMFEEDBACK, BeginTransformFeedback)                                              \
    X(BINDATTRIBLOCATION, BindAttribLocation)                                                      \
    X(BINDBUFFER, BindBuffer)                                                                      \
    X(BINDBUFFERBASE, BindBufferBase)                                                              \
    X(BINDBUFFERRANGE, BindBufferRange)                                                            \
    X(BINDFRAMEBUFFER, BindFramebuffer)                                                            \
    X(BINDRENDERBUFFER, BindRenderbuffer)                                                          \
    X(BINDSAMPLER, BindSampler)                                                                    \
    X(BINDTEXTURE, BindTexture)                                                                    \
    X(BINDVERTEXARRAY, BindVertexArray)                                                            \
    X(BLENDCOLOR, BlendColor)                                                                      \
    X(BLENDEQUATION, BlendEquation)                                                                \
    X(BLENDEQUATIONSEPARATE, BlendEquationSeparate)                                                \
    X(BLENDFUNC, BlendFunc)                                                                        \
    X(BLENDFUNCSEPARATE, BlendFuncSeparate)                                                        \
    X(BLITFRAMEBUFFER, BlitFramebuffer)                                                            \
    X(BUFFERDATA, BufferData)                                                                      \
    X(BUFFERSUBDATA, BufferSubData)                                                                \
    X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus)                                              \
    X(CLEAR, Clear)                                                                                \
    X(CLEARBUFFERFI, ClearBufferfi)                                                                \
    X(CLEARBUFFERFV, ClearBufferfv)                                                                \
    X(CLEARBUFFERIV, ClearBufferiv)                                                                \
    X(CLEARBUFFERUIV, ClearBufferuiv)                                                              \
    X(CLEARCOLOR, ClearColor)                                                                      \
    X(CLEARSTENCIL, ClearStencil)                                                                  \
    X(CLIENTWAITSYNC, ClientWaitSync)                                                              \
    X(COLORMASK, ColorMask)                                                                        \
    X(COMPILESHADER, CompileShader)                                                                \
    X(COPYBUFFERSUBDATA, CopyBufferSubData)                                                        \
    X(COPYTEXSUBIMAGE2D, CopyTexSubImage2D)                                                        \
    X(CREATEPROGRAM, CreateProgram)                                                                \
    X(CREATESHADER, CreateShader)                                                                  \
    X(CULLFACE, CullFace)                                                                          \
    X(DELETEBUFFERS, DeleteBuffers)                                                                \
    X(DELETEFRAMEBUFFERS, DeleteFramebuffers)                                                      \
    X(DELETEPROGRAM, DeleteProgram)                                                                \
    X(DELETEQUERIES, DeleteQueries)                                                                \
    X(DELETERENDERBUFFERS, DeleteRenderbuffers)                                                    \
    X(DELETESAMPLERS, DeleteSamplers)                                                              \
    X(DELETESHADER, DeleteShader)                                                                  \
    X(DELETESYNC, DeleteSync)                                                                      \
    X(DELETETEXTURES, DeleteTextures)                                                              \
    X(DELETEVERTEXARRAYS, DeleteVertexArrays)                                                      \
    X(DEPTHFUNC, DepthFunc)                                                                        \
    X(DEPTHMASK, DepthMask)                                                                        \
    X(DETACHSHADER, DetachShader)                                                                  \
    X(DISABLE, Disable)                                                                            \
    X(DISABLEVERTEXATTRIBARRAY, DisableVertexAttribArray)                                          \
    X(DRAWARRAYS, DrawArrays)                                                                      \
    X(DRAWARRAYSINSTANCED, DrawArraysInstanced)                                                    \
    X(DRAWBUFFERS, DrawBuffers)                                                                    \
    X(DRAWELEMENTS, DrawElements)                                                                  \
    X(DRAWELEMENTSINSTANCED, DrawElementsInstanced)                                                \
    X(DRAWRANGEELEMENTS, DrawRangeElements)                                                        \
    X(ENABLE, Enable)                                                                              \
    X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray)                                            \
    X(ENDQUERY, EndQuery)                                                                          \
    X(ENDTRANSFORMFEEDBACK, EndTransformFeedback)                                                  \
    X(FENCESYNC, FenceSync)                                                                        \
    X(FINISH, Finish)                                                                              \
    X(FLUSH, Flush)                                                                                \
    X(FLUSHMAPPEDBUFFERRANGE, FlushMappedBufferRange)                                              \
    X(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer)                                            \
    X(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D)                                                  \
    X(FRAMEBUFFERTEXTURELAYER, FramebufferTextureLayer)                                            \
    X(FRONTFACE, FrontFace)                                                                        \
    X(GENBUFFERS, GenBuffers)                                                                      \
    X(GENERATEMIPMAP, GenerateMipmap)                                                              \
    X(GENFRAMEBUFFERS, GenFramebuffers)                                                            \
    X(GENQUERIES, GenQueries)                                                                      \
    X(GENRENDERBUFFERS, GenRenderbuffers)                                                          \
    X(GENSAMPLERS, GenSamplers)                                                                    \
    X(GENTEXTURES, GenTextures)                                                                    \
    X(GENVERTEXARRAYS, GenVertexArrays)                                                            \
    X(GETACTIVEATTRIB, GetActiveAttrib)                                                            \
    X(GETACTIVEUNIFORM, GetActiveUniform)                                                          \
    X(GETACTIVEUNIFORMBLOCKIV, GetActiveUniformBlockiv)                                            \
    X(GETACTIVEUNIFORMBLOCKNAME, GetActiveUniformBlockName)                                        \
    X(GETACTIVEUNIFORMSIV, GetActiveUniformsiv)                                                    \
    X(GETATTRIBLOCATION, GetAttribLocation)                                                        \
    X(GETBOOLEANV, GetBooleanv)                                                                    \
    X(GETBUFFERPARAMETERIV, GetBufferParameteriv)                                                  \
    X(GETERROR, GetError)                                                                          \
    X(GETFLOATV, GetFloatv)                                                                        \
    X(GETFRAGDATALOCATION, GetFragDataLocation)                                                    \
    X(GETFRAMEBUFFERATTACHMENTPARAMETERIV, GetFramebufferAttachmentParameteriv)                    \
    X(GETINTEGER64I_V, GetInteger64i_v)                                                            \
    X(GETINTEGER64V, GetInteger64v)                                                                \
    X(GETINTEGERI_V, GetIntegeri_v)                                                                \
    X(GETINTEGERV, GetIntegerv)                                                                    \
    X(GETPROGRAMINFOLOG, GetProgramInfoLog)                                                        \
    X(GETPROGRAMIV, GetProgramiv)                                                                  \
    X(GETQUERYIV, GetQueryiv)                                                                      \
    X(GETQUERYOBJECTUIV, GetQueryObjectuiv)                                                        \
    X(GETRENDERBUFFERPARAMETERIV, GetRenderbufferParameteriv)                                      \
    X(GETSAMPLERPARAMETERFV, GetSamplerParameterfv)                                                \
    X(GETSAMPLERPARAMETERIV, GetSamplerParameteriv)                                                \
    X(GETSHADERINFOLOG, GetShaderInfoLog)                                                          \
    X(GETSHADERIV, GetShaderiv)                                                                    \
    X(GETSTRING, GetString)                                                                        \
    X(GETSTRINGI, GetStringi)                                                                      \
    X(GETTEXPARAMETERFV, GetTexParameterfv)                                                        \
    X(GETTEXPARAMETERIV, GetTexParameteriv)                                                        \
    X(GETTRANSFORMFEEDBACKVARYING, GetTransformFeedbackVarying)                                    \
    X(GETUNIFORMBLOCKINDEX, GetUniformBlockIndex)                                                  \
    X(GETUNIFORMFV, GetUniformfv)                                                                  \
    X(GETUNIFORMINDICES, GetUniformIndices)                                                        \
    X(GETUNIFORMIV, GetUniformiv)                                                                  \
    X(GETUNIFORMLOCATION, GetUniformLocation)                                                      \
    X(GETVERTEXATTRIBFV, GetVertexAttribfv)                                                        \
    X(GETVERTEXATTRIBIV, GetVertexAttribiv)                                                        \
    X(GETVERTEXATTRIBPOINTERV, GetVertexAttribPointerv)                                            \
    X(HINT, Hint)                                                                                  \
    X(ISBUFFER, IsBuffer)                                                                          \
    X(ISENABLED, IsEnabled)                                                                        \
    X(ISFRAMEBUFFER, IsFramebuffer)                                                                \
    X(ISPROGRAM, IsProgram)                                                                        \
    X(ISSAMPLER, IsSampler)                                                                        \
    X(ISTEXTURE, IsTexture)                                                                        \
    X(ISVERTEXARRAY, IsVertexArray)                                                                \
    X(LINEWIDTH, LineWidth)                                                                        \
    X(LINKPROGRAM, LinkProgram)                                                                    \
    X(MAPBUFFERRANGE, MapBufferRange)                                                              \
    X(PIXELSTOREI, PixelStorei)                                                                    \
    X(POLYGONOFFSET, PolygonOffset)                                                                \
    X(READBUFFER, ReadBuffer)                                                                      \
    X(READPIXELS, ReadPixels)                                                                      \
    X(RENDERBUFFERSTORAGE, RenderbufferStorage)                                                    \
    X(RENDERBUFFERSTORAGEMULTISAMPLE, RenderbufferStorageMultisample)                              \
    X(SAMPLECOVERAGE, SampleCoverage)                                                              \
    X(SAMPLERPARAMETERF, SamplerParameterf)                                                        \
    X(SAMPLERPARAMETERI, SamplerParameteri)                                                        \
    X(SCISSOR, Scissor)                                                                            \
    X(SHADERSOURCE, ShaderSource)                                                                  \
    X(STENCILFUNC, StencilFunc)                                                                    \
    X(STENCILFUNCSEPARATE, StencilFuncSeparate)                                                    \
    X(STENCILMASK, StencilMask)                                                                    \
    X(STENCILMASKSEPARATE, StencilMaskSeparate)                                                    \
    X(STENCILOP, StencilOp)                                                                        \
    X(STENCILOPSEPARATE, StencilOpSeparate)                                                        \
    X(TEXIMAGE2D, TexImage2D)                                                                      \
    X(TEXIMAGE3D, TexImage3D)                                                                      \
    X(TEXPARAMETERF, TexParameterf)                                                                \
    X(TEXPARAMETERI, TexParameteri)                                                                \
    X(TEXSUBIMAGE2D, TexSubImage2D)                                                                \
    X(TEXSUBIMAGE3D, TexSubImage3D)                                                                \
    X(TRANSFORMFEEDBACKVARYINGS, TransformFeedbackVaryings)                                        \
    X(UNIFORM1F, Uniform1f)                                                                        \
    X(UNIFORM1FV, Uniform1fv)                                                                      \
    X(UNIFORM1I, Uniform1i)                                                                        \
    X(UNIFORM1IV, Uniform1iv)                                                                      \
    X(UNIFORM1UI, Uniform1ui)                                                                      \
    X(UNIFORM2F, Uniform2f)                                                                        \
    X(UNIFORM2FV, Uniform2fv)                                                                      \
    X(UNIFORM2I, Uniform2i)                                                                        \
    X(UNIFORM2UI, Uniform2ui)                                                                      \
    X(UNIFORM3F, Uniform3f)                                                                        \
    X(UNIFORM3FV, Uniform3fv)                                                                      \
    X(UNIFORM3I, Uniform3i)                                                                        \
    X(UNIFORM4F, Uniform4f)                                                                        \
    X(UNIFORM4FV, Uniform4fv)                                                                      \
    X(UNIFORM4I, Uniform4i)                                                                        \
    X(UNIFORM4IV, Uniform4iv)                                                                      \
    X(UNIFORMBLOCKBINDING, UniformBlockBinding)                                                    \
    X(UNIFORMMATRIX3X4FV, UniformMatrix3x4fv)                                                      \
    X(UNIFORMMATRIX3FV, UniformMatrix3fv)                                                          \
    X(UNIFORMMATRIX4FV, UniformMatrix4fv)                                                          \
    X(UNMAPBUFFER, UnmapBuffer)                                                                    \
    X(USEPROGRAM, UseProgram)                                                                      \
    X(VALIDATEPROGRAM, ValidateProgram)                                                            \
    X(VERTEXATTRIB4F, VertexAttrib4f)                                                              \
    X(VERTEXATTRIBDIVISOR, VertexAttribDivisor)                                                    \
    X(VERTEXATTRIBIPOINTER, VertexAttribIPointer)                                                  \
    X(VERTEXATTRIBPOINTER, VertexAttribPointer)                                                    \
    X(VIEWPORT, Viewport)                                                                          \
    X(WAITSYNC, WaitSync)

// In OpenGL 3.3 core only: NULL on OpenGL ES.
#define GL_FUNCTIONS_DESKTOP(X)                                                                    \
    X(BINDFRAGDATALOCATION, BindFragDataLocation)                                                  \
    X(CLEARDEPTH, ClearDepth)                                                                      \
    X(COLORMASKI, ColorMaski)                                                                      \
    X(DEPTHRANGE, DepthRange)                                                                      \
    X(DISABLEI, Disablei)                                                                          \
    X(DRAWBUFFER, DrawBuffer)                                                                      \
    X(DRAWELEMENTSBASEVERTEX, DrawElementsBaseVertex)                                              \
    X(ENABLEI, Enablei)                                                                            \
    X(FRAMEBUFFERTEXTURE, FramebufferTexture)                                                      \
    X(GETBUFFERSUBDATA, GetBufferSubData)                                                          \
    X(GETQUERYOBJECTUI64V, GetQueryObjectui64v)                                                    \
    X(GETTEXIMAGE, GetTexImage)                                                                    \
    X(GETTEXLEVELPARAMETERIV, GetTexLevelParameteriv)                                              \
    X(ISENABLEDI, IsEnabledi)                                                                      \
    X(LOGICOP, LogicOp)                                                                            \
    X(MULTIDRAWARRAYS, MultiDrawArrays)                                                            \
    X(PIXELSTOREF, PixelStoref)                                                                    \
    X(POINTSIZE, PointSize)                                                                        \
    X(POLYGONMODE, PolygonMode)                                                                    \
    X(PRIMITIVERESTARTINDEX, PrimitiveRestartIndex)                                                \
    X(PROVOKINGVERTEX, ProvokingVertex)                                                            \
    X(QUERYCOUNTER, QueryCounter)                                                                  \
    X(TEXBUFFER, TexBuffer)                                                                        \
    X(TEXIMAGE1D, TexImage1D)

// In OpenGL 4.2 or ES 3.0 and later: immutable textures.
#define GL_FUNCTIONS_STORAGE(X)                                                                    \
    X(GETINTERNALFORMATIV, GetInternalformativ)                                                    \
    X(TEXSTORAGE2D, TexStorage2D)                                                                  \
    X(TEXSTORAGE3D, TexStorage3D)

// In OpenGL 4.1 or ES 3.0 and later: float depths, transform feedback objects, program binaries.
#define GL_FUNCTIONS_FEEDBACK(X)                                                                   \
    X(BINDTRANSFORMFEEDBACK, BindTransformFeedback)                                                \
    X(CLEARDEPTHF, ClearDepthf)                                                                    \
    X(DELETETRANSFORMFEEDBACKS, DeleteTransformFeedbacks)                                          \
    X(DEPTHRANGEF, DepthRangef)                                                                    \
    X(GENTRANSFORMFEEDBACKS, GenTransformFeedbacks)                                                \
    X(GETPROGRAMBINARY, GetProgramBinary)                                                          \
    X(PAUSETRANSFORMFEEDBACK, PauseTransformFeedback)                                              \
    X(PROGRAMPARAMETERI, ProgramParameteri)                                                        \
    X(RESUMETRANSFORMFEEDBACK, ResumeTransformFeedback)

// In OpenGL 4.3 or ES 3.2 and later: debug messages and labels, image copies.
#define GL_FUNCTIONS_DEBUG(X)                                                                      \
    X(COPYIMAGESUBDATA, CopyImageSubData)                                                          \
    X(DEBUGMESSAGECALLBACK, DebugMessageCallback)                                                  \
    X(DEBUGMESSAGECONTROL, DebugMessageControl)                                                    \
    X(OBJECTLABEL, ObjectLabel)                                                                    \
    X(POPDEBUGGROUP, PopDebugGroup)                                                                \
    X(PUSHDEBUGGROUP, PushDebugGroup)

// In OpenGL 4.5 and later: objects edited without binding them.
#define GL_FUNCTIONS_DIRECT(X)                                                                     \
    X(BINDTEXTUREUNIT, BindTextureUnit)                                                            \
    X(CLIPCONTROL, ClipControl)                                                                    \
    X(CREATEBUFFERS, CreateBuffers)                                                                \
    X(CREATEFRAMEBUFFERS, CreateFramebuffers)                                                      \
    X(CREATESAMPLERS, CreateSamplers)                                                              \
    X(CREATETEXTURES, CreateTextures)                                                              \
    X(GETTEXTUREIMAGE, GetTextureImage)                                                            \
    X(GETTEXTURELEVELPARAMETERIV, GetTextureLevelParameteriv)                                      \
    X(GETTEXTUREPARAMETERIV, GetTextureParameteriv)                                                \
    X(NAMEDBUFFERDATA, NamedBufferData)                                                            \
    X(NAMEDBUFFERSUBDATA, NamedBufferSubData)                                                      \
    X(NAMEDFRAMEBUFFERTEXTURE, NamedFramebufferTexture)                                            \
    X(TEXTUREPARAMETERI, TextureParameteri)                                                        \
    X(TEXTURESTORAGE2D, TextureStorage2D)                                                          \
    X(TEXTURESTORAGE3D, TextureStorage3D)                                                          \
    X(TEXTURESUBIMAGE2D, TextureSubImage2D)                                                        \
    X(TEXTURESUBIMAGE3D, TextureSubImage3D)

#define GL_FUNCTIONS(X)                                                                            \
    GL_FUNCTIONS_COMMON(X)                                                                         \
    GL_FUNCTIONS_DESKTOP(X)                                                                        \
    GL_FUNCTIONS_STORAGE(X)                                                                        \
    GL_FUNCTIONS_FEEDBACK(X)                                                                       \
    GL_FUNCTIONS_DEBUG(X)                                                                          \
    GL_FUNCTIONS_DIRECT(X)

#endif
